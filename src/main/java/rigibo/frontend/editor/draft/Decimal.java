package rigibo.frontend.editor.draft;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;

/**
 * Rounds numbers to what an author would write; positions set by hand are not exact to the last
 * bit.
 */
public final class Decimal {

    /** A hundredth of a pixel is 0.1 mm; level files need no more. */
    private static final double PER_UNIT = 10_000;

    /** The schema's largest number, a density; what is larger cannot be drawn either. */
    private static final double LARGEST = 100_000;

    private Decimal() {}

    /** A number of a level file, within what one may have; what is no number is something else. */
    public static double read(JsonNode node, double otherwise) {
        return node.isNumber()
                ? Math.max(-LARGEST, Math.min(LARGEST, node.doubleValue()))
                : otherwise;
    }

    /** To four places. */
    public static double rounded(double value) {
        return Math.round(value * PER_UNIT) / PER_UNIT;
    }

    /** To four places, as a level file states it. */
    public static JsonNode of(double value) {
        return JsonNodeFactory.instance.numberNode(rounded(value));
    }
}
