package rigibo.frontend.puzzle.level;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** The action of a click on a body or a joint. */
public enum Verb {
    /** A body disappears. */
    DELETE,
    /** A rope is cut. */
    CUT,
    /** A hinge or weld lets go. */
    PULL,
    /** A motor or a belt is switched on or off. */
    SWITCH,
    /** A body becomes a stone that stays where it is. */
    FREEZE,
    /** The fuse of a bomb is lit. */
    LIGHT;

    /** The name in level files. */
    public String title() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** The verb of a name in level files. */
    public static Optional<Verb> titled(String title) {
        return Arrays.stream(values()).filter(verb -> verb.title().equals(title)).findFirst();
    }

    /** Whether it acts on joints of a kind. */
    public boolean actsOn(LevelJoint.Type type) {
        return switch (this) {
            case CUT -> type == LevelJoint.Type.ROPE;
            case PULL -> type == LevelJoint.Type.HINGE || type == LevelJoint.Type.WELD;
            case SWITCH ->
                    type == LevelJoint.Type.HINGE
                            || type == LevelJoint.Type.WHEEL
                            || type == LevelJoint.Type.SLIDE;
            case DELETE, FREEZE, LIGHT -> false;
        };
    }

    /** Whether what it acted on can be clicked again. */
    public boolean repeats() {
        return this == SWITCH;
    }
}
