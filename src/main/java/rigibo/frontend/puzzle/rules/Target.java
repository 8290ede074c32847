package rigibo.frontend.puzzle.rules;

import rigibo.frontend.puzzle.level.Verb;

import java.util.Optional;

/** A body or joint of the level in play at which a click may be aimed. */
public sealed interface Target permits Piece, Link {

    /** Its id, unique in its level. */
    String id();

    /** The action of a click on it; empty if there is none. */
    Optional<Verb> verb();

    /** Whether it is still in the world. */
    boolean isAlive();

    /** Whether it is on, if clicks switch it. */
    boolean isOn();

    /** World x at which a pointer aims at it, m. */
    double x();

    /** World y at which a pointer aims at it, m, up. */
    double y();

    /** Whether a click acts on it. */
    default boolean isClickable() {
        return isAlive() && verb().isPresent();
    }

    /** Whether a click acts on it by a verb. */
    default boolean is(Verb by) {
        return verb().filter(by::equals).isPresent();
    }
}
