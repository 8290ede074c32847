package rigibo.frontend.editor.draft;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;

/** Numbers as an author would write them: what a hand moves is not exact to the last bit. */
public final class Decimal {

    /** A tenth of a pixel is 1 mm; level files need no more. */
    private static final double PER_UNIT = 1000;

    private Decimal() {}

    /** To three places. */
    public static double rounded(double value) {
        return Math.round(value * PER_UNIT) / PER_UNIT;
    }

    /** To three places, as a level file states it. */
    public static JsonNode of(double value) {
        return JsonNodeFactory.instance.numberNode(rounded(value));
    }
}
