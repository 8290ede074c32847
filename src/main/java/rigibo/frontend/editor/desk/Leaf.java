package rigibo.frontend.editor.desk;

import java.util.List;
import java.util.Locale;

/** The leaves of the fields at the right, of which one is turned to. */
public enum Leaf {
    /** Place and outline of a body. */
    SHAPE,
    /** What a body does in play: clicks, belts, fans, magnets, paths. */
    PLAY,
    /** What a body is made of, and how it moves at the start. */
    MATTER,
    /** Words and world of the level. */
    LEVEL,
    /** What wins, and how fast. */
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
