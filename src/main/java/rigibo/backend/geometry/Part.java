package rigibo.backend.geometry;

/**
 * One convex shape of a {@link Compound}, and where it sits. Immutable: every verb returns another
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
        if (shape == null) {
            throw new IllegalArgumentException("Part.shape must be present, was null");
        }
        return new Part(shape, 0, 0, 0, 1, false);
    }

    /**
     * The same with its own centre of mass somewhere else.
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
     * The same turned about its own centre of mass, rad, counter-clockwise.
     *
     * @throws IllegalArgumentException when the angle is not finite
     */
    public Part angle(double radians) {
        return new Part(
                shape, x, y, requireFinite("angle", radians, "rad"), relativeDensity, isSensor);
    }

    /**
     * The same of a stuff so many times as dense as the material of the body.
     *
     * @param factor 0, which weighs nothing, to 10⁶
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
     * The same as a sensor, which touches nothing and tells who is inside, where {@code Sensors}
     * are declared. It weighs nothing unless a relative density is stated after this.
     */
    public Part sensor() {
        return new Part(shape, x, y, angle, 0, true);
    }

    /** Whether it touches nothing and tells who is inside. */
    public boolean isSensor() {
        return isSensor;
    }

    /** The shape. */
    public Convex shape() {
        return shape;
    }

    /** Of its centre of mass in the compound's frame, m. */
    public double x() {
        return x;
    }

    /** Of its centre of mass in the compound's frame, m. */
    public double y() {
        return y;
    }

    /** How far it is turned in the compound's frame, rad, counter-clockwise. */
    public double angle() {
        return angle;
    }

    /** How many times as dense as the body's material it is. */
    public double relativeDensity() {
        return relativeDensity;
    }

    /** The outline seen from a point of the compound's frame, m. */
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
