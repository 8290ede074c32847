package rigibo.lab.hardcase;

import java.util.List;

/** All hard cases. To add one, write its class and a line in one of the three lists. */
public final class HardCases {

    private static final List<HardCase> HELD =
            joined(List.of(NumberedCases.held(), MovingPiles.held(), JointCases.held()));

    /** Cases that do not yet keep every limit, or take long to. */
    private static final List<HardCase> OPEN =
            joined(List.of(NumberedCases.open(), MovingPiles.open(), JointCases.open()));

    private static final List<HardCase> LONG =
            joined(List.of(NumberedCases.longRuns(), MovingPiles.longRuns()));

    private HardCases() {}

    /** Cases that keep every limit at GAME and at EXACT; tests hold them there. */
    public static List<HardCase> held() {
        return HELD;
    }

    /** Cases that take minutes; they run only when asked for by their row. */
    public static List<HardCase> longRuns() {
        return LONG;
    }

    /** All cases but the long runs. */
    public static List<HardCase> all() {
        return joined(List.of(HELD, OPEN));
    }

    private static List<HardCase> joined(List<List<HardCase>> rooms) {
        return rooms.stream().flatMap(List::stream).toList();
    }
}
