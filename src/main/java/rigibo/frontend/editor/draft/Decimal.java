package rigibo.frontend.editor.draft;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;

/** Numbers as an author would write them: what a hand moves is not exact to the last bit. */
public final class Decimal {

    /** A hundredth of a pixel is 0.1 mm; level files need no more. */
    private static final double PER_UNIT = 10_000;

    private Decimal() {}

    /** To four places. */
    public static double rounded(double value) {
        return Math.round(value * PER_UNIT) / PER_UNIT;
    }

    /** To four places, as a level file states it. */
    public static JsonNode of(double value) {
        return JsonNodeFactory.instance.numberNode(rounded(value));
    }
}
