package rigibo.frontend.editor.draft;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;

/**
 * Rounds numbers to what an author would write; positions set by hand are not exact to the last
 * bit.
 */
public final class Decimal {

    /** Number of decimal places; a hundredth of a pixel is 0.1 mm, and level files need no more. */
    private static final double PER_UNIT = 10_000;

    /** Largest number in the schema, a density; anything larger could not be drawn either. */
    private static final double LARGEST = 100_000;

    private Decimal() {}

    /**
     * Reduces a number to the range that a level file allows; a value that is not a number is
     * replaced.
     */
    public static double read(JsonNode node, double otherwise) {
        return node.isNumber()
                ? Math.max(-LARGEST, Math.min(LARGEST, node.doubleValue()))
                : otherwise;
    }

    /** Rounds to four places. */
    public static double rounded(double value) {
        return Math.round(value * PER_UNIT) / PER_UNIT;
    }

    /** Rounds to four places, as a level file states the number. */
    public static JsonNode of(double value) {
        return JsonNodeFactory.instance.numberNode(rounded(value));
    }
}
