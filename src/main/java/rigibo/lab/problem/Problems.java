package rigibo.lab.problem;

import java.util.List;

/** All of them, in the order of their numbers. */
public final class Problems {

    private static final List<Problem> ALL = List.of(new BallisticFlight());

    private Problems() {}

    public static List<Problem> all() {
        return ALL;
    }
}
