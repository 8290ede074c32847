package rigibo.frontend.puzzle.level;

import java.util.List;

/**
 * A path of straight lines along which a body is driven, from its start to each stop in turn.
 *
 * @param stops positions of its centre of mass, m, without the start; one or more
 * @param speed m/s
 * @param pause time for which it stands at the start and at each stop, s
 * @param end what it does at the last stop
 */
public record LevelPath(List<Stop> stops, double speed, double pause, End end) {

    /** Checks that there is somewhere to go. */
    public LevelPath {
        stops = List.copyOf(stops);
        if (stops.isEmpty()) {
            throw new IllegalArgumentException("LevelPath.stops must be one or more, were none");
        }
    }

    /** A place of the centre of mass, world m. */
    public record Stop(double x, double y) {}

    /** What a body does at the end of its path. */
    public enum End {
        /** Goes back the way it came, and on again. */
        BACK,
        /** Goes straight to its start, and on again. */
        ROUND,
        /** Stays there. */
        STAY
    }
}
