package rigibo.backend.geometry;

/**
 * One convex shape of a {@link Compound} and its placement. Immutable: every verb returns a new
 * part.
 *
 * <pre>{@code
 * Part head = Part.of(Polygon.box(0.5, 0.2)).at(0, 0.5).angle(0.1).relativeDensity(8);
 * }</pre>
 */
public final class Part {

    private final Convex shape;
    private final double x;
    private final double y;
    private final double angle;
    private final double relativeDensity;
    private final boolean isSensor;

    private Part(
            Convex shape,
            double x,
            double y,
            double angle,
            double relativeDensity,
            boolean isSensor) {
        this.isSensor = isSensor;
        this.shape = shape;
        this.x = x;
        this.y = y;
        this.angle = angle;
        this.relativeDensity = relativeDensity;
    }

    /** A shape with its centre of mass at the origin of the compound's frame. */
    public static Part of(Convex shape) {
        PolygonCheck.requirePresent("Part.shape", shape);
        return new Part(shape, 0, 0, 0, 1, false);
    }

    /**
     * Returns this part with its own centre of mass at a point of the compound's frame.
     *
     * @param metresX in the compound's frame, m, finite
     * @param metresY in the compound's frame, m, finite
     * @throws IllegalArgumentException when a coordinate is not finite
     */
    public Part at(double metresX, double metresY) {
        return new Part(
                shape,
                requireFinite("x", metresX, "m"),
                requireFinite("y", metresY, "m"),
                angle,
                relativeDensity,
                isSensor);
    }

    /**
     * Returns this part turned about its own centre of mass, rad, counter-clockwise.
     *
     * @throws IllegalArgumentException when the angle is not finite
     */
    public Part angle(double radians) {
        return new Part(
                shape, x, y, requireFinite("angle", radians, "rad"), relativeDensity, isSensor);
    }

    /**
     * Returns this part with a density relative to the material of the body.
     *
     * @param factor 0 (no mass) to 10⁶
     * @throws IllegalArgumentException when the factor is out of range
     */
    public Part relativeDensity(double factor) {
        if (!(factor >= 0 && factor <= 1e6)) {
            throw new IllegalArgumentException(
                    "Part.relativeDensity must be 0 to 10⁶ (no unit), was " + factor);
        }
        return new Part(shape, x, y, angle, factor, isSensor);
    }

    /**
     * Returns this part as a sensor: it touches nothing, and where {@code Sensors} are declared it
     * reports the bodies inside it. It has no mass unless a relative density is stated afterwards.
     */
    public Part sensor() {
        return new Part(shape, x, y, angle, 0, true);
    }

    /** Whether this part is a sensor, which touches nothing and reports the bodies inside it. */
    public boolean isSensor() {
        return isSensor;
    }

    /** The shape. */
    public Convex shape() {
        return shape;
    }

    /** The x of its centre of mass in the compound's frame, m. */
    public double x() {
        return x;
    }

    /** The y of its centre of mass in the compound's frame, m. */
    public double y() {
        return y;
    }

    /** Its angle in the compound's frame, rad, counter-clockwise. */
    public double angle() {
        return angle;
    }

    /** Its density divided by that of the body's material. */
    public double relativeDensity() {
        return relativeDensity;
    }

    /** The outline relative to a point of the compound's frame, m. */
    Outline outlineFrom(double originX, double originY) {
        double cos = Angle.cos(angle);
        double sin = Angle.sin(angle);
        Outline own = shape.outline();
        double[] cornerX = new double[own.corners()];
        double[] cornerY = new double[own.corners()];
        for (int i = 0; i < cornerX.length; i++) {
            cornerX[i] = x - originX + (cos * own.cornerX(i) - sin * own.cornerY(i));
            cornerY[i] = y - originY + (sin * own.cornerX(i) + cos * own.cornerY(i));
        }
        return Outline.of(cornerX, cornerY, own.radius());
    }

    private static double requireFinite(String field, double value, String unit) {
        if (!(Math.abs(value) < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "Part." + field + " must be finite (" + unit + "), was " + value);
        }
        return value;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Part part
                && shape.equals(part.shape)
                && x == part.x
                && y == part.y
                && angle == part.angle
                && relativeDensity == part.relativeDensity
                && isSensor == part.isSensor;
    }

    @Override
    public int hashCode() {
        return 31 * shape.hashCode() + Double.hashCode(x + 7 * y + 31 * angle);
    }

    @Override
    public String toString() {
        return shape + " at (" + x + ", " + y + ") m, " + angle + " rad";
    }
}
