package rigibo.backend.setup;

/**
 * Argument checks of the public API. Each throws an {@link IllegalArgumentException} that names the
 * field, the value, the unit and the allowed range, and otherwise returns the value.
 *
 * <pre>{@code
 * double speed = Require.positive("Lift.speed", 2, "m/s"); // or an exception that says it all
 * }</pre>
 */
public final class Require {

    private Require() {}

    /** Refuses NaN and infinities. */
    public static double finite(String field, double value, String unit) {
        if (!(Math.abs(value) < Double.POSITIVE_INFINITY)) {
            throw refused(field, "finite", value, unit);
        }
        return value;
    }

    /** Refuses NaN, infinity, zero and negative values. */
    public static double positive(String field, double value, String unit) {
        if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
            throw refused(field, "positive and finite", value, unit);
        }
        return value;
    }

    /** Refuses NaN, infinity and negative values. */
    public static double notNegative(String field, double value, String unit) {
        if (!(value >= 0 && value < Double.POSITIVE_INFINITY)) {
            throw refused(field, "zero or more and finite", value, unit);
        }
        return value;
    }

    /** Refuses NaN and values outside [least, most]. */
    public static double within(
            String field, double value, double least, double most, String unit) {
        if (!(value >= least && value <= most)) {
            throw refused(field, least + " to " + most, value, unit);
        }
        return value;
    }

    /** Refuses whole numbers outside [least, most]. */
    public static int within(String field, int value, int least, int most) {
        if (value < least || value > most) {
            throw new IllegalArgumentException(
                    field + " must be " + least + " to " + most + ", was " + value);
        }
        return value;
    }

    /** Refuses null. */
    public static <T> T present(String field, T value) {
        if (value == null) {
            throw new IllegalArgumentException(field + " must be given, was null");
        }
        return value;
    }

    private static IllegalArgumentException refused(
            String field, String range, double value, String unit) {
        return new IllegalArgumentException(
                field + " must be " + range + " (" + unit + "), was " + value);
    }
}
