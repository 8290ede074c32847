package rigibo.backend.geometry;

/**
 * The pose of a shape: its centre of mass and its angle.
 *
 * <pre>{@code
 * Placement ahead = Placement.at(3, 1).angle(Math.PI / 4);
 * }</pre>
 *
 * @param x world x, m
 * @param y world y, m, up
 * @param angle rad, counter-clockwise
 */
public record Placement(double x, double y, double angle) {

    /** The origin of the world, at angle 0. */
    public static final Placement ORIGIN = new Placement(0, 0, 0);

    /**
     * Checks every number.
     *
     * @throws IllegalArgumentException naming the number that is not finite
     */
    public Placement {
        requireFinite("x", x, "m");
        requireFinite("y", y, "m");
        requireFinite("angle", angle, "rad");
    }

    /** A placement at a point (m) and angle 0. */
    public static Placement at(double x, double y) {
        return new Placement(x, y, 0);
    }

    /** Returns this placement with another angle in rad, counter-clockwise. */
    public Placement angle(double radians) {
        return new Placement(x, y, radians);
    }

    private static void requireFinite(String field, double value, String unit) {
        if (!(Math.abs(value) < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "Placement." + field + " must be finite (" + unit + "), was " + value);
        }
    }
}
