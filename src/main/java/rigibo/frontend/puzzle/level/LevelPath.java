package rigibo.frontend.puzzle.level;

import java.util.List;

/**
 * A path of straight lines along which a body is driven, from its start to each stop in turn.
 *
 * @param stops positions of its centre of mass, m, without the start; one or more
 * @param speed m/s
 * @param pause time spent at the start and at each stop, s
 * @param end behaviour at the last stop
 */
public record LevelPath(List<Stop> stops, double speed, double pause, End end) {

    /** Checks that there is at least one stop. */
    public LevelPath {
        stops = List.copyOf(stops);
        if (stops.isEmpty()) {
            throw new IllegalArgumentException("LevelPath.stops must be one or more, were none");
        }
    }

    /** A place of the centre of mass, world m. */
    public record Stop(double x, double y) {}

    /** The behaviour of a body at the end of its path. */
    public enum End {
        /** Goes back along the path, and forth again. */
        BACK,
        /** Goes straight to its start, and along the path again. */
        ROUND,
        /** Stays there. */
        STAY
    }
}
