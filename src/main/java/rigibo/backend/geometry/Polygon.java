package rigibo.backend.geometry;

import java.util.Arrays;

/**
 * A convex polygon of 3 to 256 corners, counter-clockwise. The corners are kept relative to the
 * centroid: wherever the points were given, the centre of mass is the shape's origin.
 */
public final class Polygon implements Shape {

    /** Most corners of a polygon: enough for a wheel that rolls within 2 % of a disc. */
    public static final int MAX_CORNERS = 256;

    /**
     * Offset of the centroid, per size of the coordinates, that is round-off of the sums: corners
     * given about the centroid stay as they are, so that a box is its own mirror image to the bit.
     */
    private static final double CENTROID_ROUNDING = 1e-15;

    /** As they were given: centred corners give another centroid and area in the last bit. */
    private final double[] stated;

    private final double[] cornerX;
    private final double[] cornerY;
    private final double[] normalX;
    private final double[] normalY;
    private final double shiftX;
    private final double shiftY;
    private final double area;
    private final double inertiaPerDensity;
    private final double boundingRadius;
    private final double innerRadius;
    private final double smallestWidth;
    private final boolean isBox;

    private Polygon(double[] xy) {
        MassProperties plate = MassProperties.ofPolygon(1, xy);
        int count = xy.length / 2;
        stated = xy;
        cornerX = new double[count];
        cornerY = new double[count];
        normalX = new double[count];
        normalY = new double[count];
        shiftX = offset(xy, 0, plate.centroidX());
        shiftY = offset(xy, 1, plate.centroidY());
        for (int i = 0; i < count; i++) {
            cornerX[i] = xy[2 * i] - shiftX;
            cornerY[i] = xy[2 * i + 1] - shiftY;
        }
        area = plate.mass();
        inertiaPerDensity = plate.inertia();
        for (int i = 0; i < count; i++) {
            writeNormal(i, (i + 1) % count);
        }
        boundingRadius = farthestCorner();
        innerRadius = nearestEdge();
        smallestWidth = narrowest();
        isBox = findBox();
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
            xy[2 * i] = radius * StrictMath.cos(angle);
            xy[2 * i + 1] = radius * StrictMath.sin(angle);
        }
        return of(xy);
    }

    /**
     * A convex polygon from its corners, which are moved so that their centroid is the origin: a
     * body's place is that of its centre of mass. For the corners to be where they are stated, the
     * body is placed at {@link #centroidX}, {@link #centroidY}:
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
        double[] stated = xy.clone();
        PolygonCheck.requireConvex(stated);
        return new Polygon(stated);
    }

    /**
     * Whether this is a rectangle about its centre, with sides along its own axes and the lower
     * left corner first: then corner 2 holds half the width and half the height.
     */
    public boolean isBox() {
        return isBox;
    }

    /**
     * The corner coordinates x₀, y₀, x₁, y₁, … in m that this polygon was made of: {@link #of}
     * makes the same of them to the last bit.
     */
    public double[] stated() {
        return stated.clone();
    }

    /** Where the centroid was among the corners as they were stated, m, to the right. */
    public double centroidX() {
        return shiftX;
    }

    /** Where the centroid was among the corners as they were stated, m, up. */
    public double centroidY() {
        return shiftY;
    }

    /** Number of corners, which is also the number of edges. */
    public int corners() {
        return cornerX.length;
    }

    /** A corner's x relative to the centre of mass, m; corners are counter-clockwise. */
    public double cornerX(int i) {
        return cornerX[i];
    }

    /** A corner's y relative to the centre of mass, m; corners are counter-clockwise. */
    public double cornerY(int i) {
        return cornerY[i];
    }

    /** The x of the outward unit normal of the edge from corner i to the next. */
    public double normalX(int i) {
        return normalX[i];
    }

    /** The y of the outward unit normal of the edge from corner i to the next. */
    public double normalY(int i) {
        return normalY[i];
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
        return boundingRadius;
    }

    /** Distance in m from the centre of mass to the nearest edge. */
    public double innerRadius() {
        return innerRadius;
    }

    @Override
    public double smallestWidth() {
        return smallestWidth;
    }

    @Override
    public void bounds(double x, double y, double cos, double sin, Aabb out) {
        double minX = Double.POSITIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < cornerX.length; i++) {
            double px = cos * cornerX[i] - sin * cornerY[i];
            double py = sin * cornerX[i] + cos * cornerY[i];
            minX = Math.min(minX, px);
            maxX = Math.max(maxX, px);
            minY = Math.min(minY, py);
            maxY = Math.max(maxY, py);
        }
        out.set(x + minX, y + minY, x + maxX, y + maxY);
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
     * What to take off the coordinates of one axis: the centroid's, or 0 where that is round-off.
     */
    private static double offset(double[] xy, int axis, double centroid) {
        double size = 0;
        for (int i = axis; i < xy.length; i += 2) {
            size = Math.max(size, Math.abs(xy[i]));
        }
        return Math.abs(centroid) > CENTROID_ROUNDING * size ? centroid : 0;
    }

    private void writeNormal(int i, int next) {
        double ex = cornerX[next] - cornerX[i];
        double ey = cornerY[next] - cornerY[i];
        double length = Math.sqrt(ex * ex + ey * ey);
        normalX[i] = ey / length;
        normalY[i] = -ex / length;
    }

    private double farthestCorner() {
        double most = 0;
        for (int i = 0; i < cornerX.length; i++) {
            most = Math.max(most, cornerX[i] * cornerX[i] + cornerY[i] * cornerY[i]);
        }
        return Math.sqrt(most);
    }

    private double nearestEdge() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < cornerX.length; i++) {
            least = Math.min(least, normalX[i] * cornerX[i] + normalY[i] * cornerY[i]);
        }
        return least;
    }

    private boolean findBox() {
        double w = cornerX[2];
        double h = cornerY[2];
        return cornerX.length == 4
                && Arrays.equals(cornerX, new double[] {-w, w, w, -w})
                && Arrays.equals(cornerY, new double[] {-h, -h, h, h});
    }

    /** A convex polygon is narrowest across one of its edges (rotating calipers). */
    private double narrowest() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < cornerX.length; i++) {
            double deepest = 0;
            for (int j = 0; j < cornerX.length; j++) {
                double across =
                        normalX[i] * (cornerX[i] - cornerX[j])
                                + normalY[i] * (cornerY[i] - cornerY[j]);
                deepest = Math.max(deepest, across);
            }
            least = Math.min(least, deepest);
        }
        return least;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Polygon
                && Arrays.equals(cornerX, ((Polygon) other).cornerX)
                && Arrays.equals(cornerY, ((Polygon) other).cornerY);
    }

    @Override
    public int hashCode() {
        return 31 * Arrays.hashCode(cornerX) + Arrays.hashCode(cornerY);
    }

    @Override
    public String toString() {
        return "Polygon[" + cornerX.length + " corners, " + area + " m²]";
    }
}
