package rigibo.backend.geometry;

/**
 * A convex polygon of 3 to 256 corners, counter-clockwise, sharp or {@linkplain #rounded rounded}.
 * Its origin is the centre of mass: the corners are kept relative to the centroid, wherever the
 * caller states them.
 *
 * <pre>{@code
 * Polygon box = Polygon.box(2, 1);
 * Polygon wedge = Polygon.of(0, 0, 3, 0, 0, 1); // counter-clockwise
 * Polygon nut = Polygon.regular(6, 0.5).rounded(0.05);
 * }</pre>
 */
public final class Polygon implements Convex {

    /** Most corners of a polygon: enough for a wheel that rolls within 2 % of a disc. */
    public static final int MAX_CORNERS = 256;

    /**
     * Largest offset of the centroid, relative to the size of the coordinates, that counts as
     * round-off. Within it, corners stay as they were stated, so that a box is its own mirror image
     * to the bit.
     */
    private static final double CENTROID_ROUNDING = 1e-15;

    /**
     * Largest corner radius, in bounding radii of the core; with a larger one, a double would lose
     * all digits of the corners.
     */
    private static final double MOST_ROUNDING = 1e6;

    /**
     * Corners as the caller stated them; the centred ones would give another centroid and area in
     * the last bit.
     */
    private final double[] stated;

    private final Outline outline;
    private final double shiftX;
    private final double shiftY;
    private final double area;
    private final double inertiaPerDensity;

    private Polygon(double[] xy, double radius) {
        MassProperties plate = MassProperties.ofPolygon(1, xy);
        if (radius > 0) {
            plate = RoundedMass.around(plate, xy, radius);
        }
        int count = xy.length / 2;
        stated = xy;
        shiftX = offset(xy, 0, plate.centroidX());
        shiftY = offset(xy, 1, plate.centroidY());
        double[] cornerX = new double[count];
        double[] cornerY = new double[count];
        for (int i = 0; i < count; i++) {
            cornerX[i] = xy[2 * i] - shiftX;
            cornerY[i] = xy[2 * i + 1] - shiftY;
        }
        outline = Outline.of(cornerX, cornerY, radius);
        area = plate.mass();
        inertiaPerDensity = plate.inertia();
    }

    /**
     * A rectangle, axis-aligned in its own frame.
     *
     * @param width m, positive and finite
     * @param height m, positive and finite
     * @throws IllegalArgumentException when a side is not positive and finite
     */
    public static Polygon box(double width, double height) {
        requireSide("Polygon.box width", width);
        requireSide("Polygon.box height", height);
        double w = width / 2;
        double h = height / 2;
        return of(-w, -h, w, -h, w, h, -w, h);
    }

    /**
     * A regular polygon with one corner on its x axis.
     *
     * @param corners 3 to 256
     * @param radius from the centre to a corner, m, positive and finite
     * @throws IllegalArgumentException when either is out of range
     */
    public static Polygon regular(int corners, double radius) {
        if (corners < 3 || corners > MAX_CORNERS) {
            throw new IllegalArgumentException(
                    "Polygon.regular corners must be 3 to " + MAX_CORNERS + ", was " + corners);
        }
        requireSide("Polygon.regular radius", radius);
        double[] xy = new double[2 * corners];
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * i / corners;
            xy[2 * i] = radius * Angle.cos(angle);
            xy[2 * i + 1] = radius * Angle.sin(angle);
        }
        return of(xy);
    }

    /**
     * A convex polygon from its corners. They are shifted so that their centroid is the origin,
     * because a body's position is that of its centre of mass. To keep the corners where they are
     * stated, place the body at {@link #centroidX}, {@link #centroidY}:
     *
     * <pre>{@code
     * Polygon wedge = Polygon.of(0, 0, 3, 0, 0, 1);
     * pool.add(BodyDefinition.dynamic(wedge).at(wedge.centroidX(), wedge.centroidY()));
     * }</pre>
     *
     * @param xy corner coordinates x₀, y₀, x₁, y₁, … in m, counter-clockwise, 3 to 256 corners,
     *     convex and without repeated or collinear corners
     * @throws IllegalArgumentException naming the corner that is not finite, repeated, collinear or
     *     reflex, or the count that is out of range
     */
    public static Polygon of(double... xy) {
        PolygonCheck.requirePresent("Polygon.of xy", xy);
        double[] stated = xy.clone();
        PolygonCheck.requireConvex(stated);
        return new Polygon(stated, 0);
    }

    /**
     * The convex hull of some points: the smallest convex polygon that holds them. Points inside it
     * or on an edge are ignored.
     *
     * @param xy coordinates x₀, y₀, x₁, y₁, … of the points in m, in any order
     * @throws IllegalArgumentException when one is not finite, all lie on one line, or more than
     *     256 are corners
     */
    public static Polygon hull(double... xy) {
        double[] corners = Hull.of(xy);
        PolygonCheck.requireHull(corners);
        return of(corners);
    }

    /**
     * Returns this polygon grown by a radius on every side, with round corners: all points within
     * that radius of it.
     *
     * <pre>{@code
     * Polygon die = Polygon.box(0.8, 0.8).rounded(0.1); // a square of 1 m with round corners
     * }</pre>
     *
     * @param radius m, from 0 (a sharp polygon) to 10⁶ times the bounding radius of the sharp
     *     polygon
     * @throws IllegalArgumentException when the radius is out of range
     */
    public Polygon rounded(double radius) {
        double most = MOST_ROUNDING * outline.sweepRadius();
        if (!(radius >= 0 && radius <= most)) {
            throw new IllegalArgumentException(
                    "Polygon.rounded radius must be 0 to " + most + " (m), was " + radius);
        }
        return new Polygon(stated, radius);
    }

    /**
     * Whether this is a sharp rectangle, centred, with sides along its own axes and the lower left
     * corner first. If so, corner 2 is (half the width, half the height).
     */
    public boolean isBox() {
        return outline.isBox();
    }

    /**
     * The corner coordinates x₀, y₀, x₁, y₁, … in m that this polygon was made of. {@link #of} and
     * {@link #rounded} make an equal polygon from them, to the last bit.
     */
    public double[] stated() {
        return stated.clone();
    }

    /** The x of the centroid in the frame in which the corners were stated, m. */
    public double centroidX() {
        return shiftX;
    }

    /** The y of the centroid in the frame in which the corners were stated, m, up. */
    public double centroidY() {
        return shiftY;
    }

    /** Number of corners, which is also the number of edges. */
    public int corners() {
        return outline.corners();
    }

    @Override
    public double originX() {
        return 0 - shiftX;
    }

    @Override
    public double originY() {
        return 0 - shiftY;
    }

    /** A corner's x relative to the centre of mass, m; corners are counter-clockwise. */
    public double cornerX(int i) {
        return outline.cornerX(i);
    }

    /** A corner's y relative to the centre of mass, m; corners are counter-clockwise. */
    public double cornerY(int i) {
        return outline.cornerY(i);
    }

    /** The x of the outward unit normal of the edge from corner i to the next. */
    public double normalX(int i) {
        return outline.normalX(i);
    }

    /** The y of the outward unit normal of the edge from corner i to the next. */
    public double normalY(int i) {
        return outline.normalY(i);
    }

    /** Corner radius in m; 0 for a sharp polygon. */
    public double radius() {
        return outline.radius();
    }

    @Override
    public Outline outline() {
        return outline;
    }

    @Override
    public ShapeKind kind() {
        return ShapeKind.POLYGON;
    }

    @Override
    public double area() {
        return area;
    }

    @Override
    public MassProperties massProperties(double density) {
        requireDensity(density);
        return new MassProperties(density * area, density * inertiaPerDensity, 0, 0);
    }

    @Override
    public double boundingRadius() {
        return outline.boundingRadius();
    }

    /** Distance in m from the centre of mass to the nearest edge. */
    public double innerRadius() {
        return outline.innerRadius() + outline.radius();
    }

    @Override
    public double smallestWidth() {
        return outline.smallestWidth();
    }

    @Override
    public void bounds(double x, double y, double cos, double sin, Aabb out) {
        outline.bounds(x, y, cos, sin, out);
    }

    static void requireDensity(double density) {
        if (!(density > 0 && density < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "density must be positive and finite (kg/m²), was " + density);
        }
    }

    private static void requireSide(String what, double metres) {
        if (!(metres > 0 && metres < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    what + " must be positive and finite (m), was " + metres);
        }
    }

    /**
     * Offset to subtract from the coordinates of one axis, m: the centroid's, or 0 where that is
     * round-off.
     */
    private static double offset(double[] xy, int axis, double centroid) {
        double size = 0;
        for (int i = axis; i < xy.length; i += 2) {
            size = Math.max(size, Math.abs(xy[i]));
        }
        return Math.abs(centroid) > CENTROID_ROUNDING * size ? centroid : 0;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Polygon polygon && outline.equals(polygon.outline);
    }

    @Override
    public int hashCode() {
        return outline.hashCode();
    }

    @Override
    public String toString() {
        String rounding = radius() > 0 ? ", rounded by " + radius() + " m" : "";
        return "Polygon[" + corners() + " corners" + rounding + ", " + area + " m²]";
    }
}
