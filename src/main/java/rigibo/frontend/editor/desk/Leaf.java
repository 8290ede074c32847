package rigibo.frontend.editor.desk;

import java.util.List;
import java.util.Locale;

/** The leaves of the fields at the right, one of which is shown. */
public enum Leaf {
    /** Place and outline of a body. */
    SHAPE,
    /** The behaviour of a body in play: clicks, belts, fans, magnets, paths. */
    PLAY,
    /** The material of a body, and its motion at the start. */
    MATTER,
    /** Words and world of the level. */
    LEVEL,
    /** How the level is won, and the clicks for each medal. */
    RULES,
    /** The secret star. */
    STAR;

    /** The leaves of a body. */
    public static final List<Leaf> OF_BODY = List.of(SHAPE, PLAY, MATTER);

    /** The leaves of the level as a whole. */
    public static final List<Leaf> OF_LEVEL = List.of(LEVEL, RULES, STAR);

    /** Key of its name among the words of the editor. */
    public String key() {
        return "leaf." + name().toLowerCase(Locale.ROOT);
    }
}
