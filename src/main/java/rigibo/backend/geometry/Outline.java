package rigibo.backend.geometry;

import java.util.Arrays;
import java.util.Objects;

/**
 * The outline of a convex shape for collision detection: all points at a distance {@link #radius}
 * from a core of corners. The core of a disc is one point, that of a capsule two, that of a polygon
 * its corners; the radius of a sharp polygon is 0. Coordinates are relative to the body's centre of
 * mass. Immutable.
 *
 * <pre>{@code
 * Outline pill = new Capsule(0.5, 0.2).outline();
 * System.out.println(pill.corners() + " corners, round by " + pill.radius() + " m"); // 2, 0.2 m
 * }</pre>
 */
public final class Outline {

    /** Values of {@link #leads}: a direction leads out of the compound, or into another part. */
    public static final int OUT = -1;

    public static final int INSIDE = -2;

    /**
     * Sine of the turn between two edges of a chain below which they count as one straight line.
     */
    static final double STRAIGHT = 1e-9;

    private static final double[] NOTHING = {};
    private static final double[] CENTRE = {0};

    private final double[] cornerX;
    private final double[] cornerY;
    private final double[] normalX;
    private final double[] normalY;
    private final double radius;
    private final double coreReach;
    private final double innerRadius;
    private final double smallestWidth;
    private final boolean isBox;

    /** Neighbours of a chain's edge; null for every other outline. */
    private final EdgeEnd before;

    private final EdgeEnd after;

    /** The edges that other parts of the body cover; null if they cover none. */
    private CoveredEdges inner;

    /** A disc centred on the centre of mass. */
    static Outline ofDisc(double radius) {
        return new Outline(CENTRE, CENTRE, NOTHING, NOTHING, radius, null, null);
    }

    /** A core of corners, counter-clockwise, and a radius of 0 or more. */
    static Outline of(double[] cornerX, double[] cornerY, double radius) {
        if (cornerX.length == 1) {
            return new Outline(cornerX, cornerY, NOTHING, NOTHING, radius, null, null);
        }
        double[] normalX = new double[cornerX.length];
        double[] normalY = new double[cornerX.length];
        for (int i = 0; i < cornerX.length; i++) {
            int next = (i + 1) % cornerX.length;
            double ex = cornerX[next] - cornerX[i];
            double ey = cornerY[next] - cornerY[i];
            double length = Math.sqrt(ex * ex + ey * ey);
            normalX[i] = ey / length;
            normalY[i] = -ex / length;
        }
        return new Outline(cornerX, cornerY, normalX, normalY, radius, null, null);
    }

    /** An edge of a chain from the first corner to the second, with matter on its left. */
    static Outline ofEdge(double[] cornerX, double[] cornerY, EdgeEnd before, EdgeEnd after) {
        double ex = cornerX[1] - cornerX[0];
        double ey = cornerY[1] - cornerY[0];
        double length = Math.sqrt(ex * ex + ey * ey);
        double nx = ey / length;
        double ny = -ex / length;
        return new Outline(
                cornerX, cornerY, new double[] {nx, -nx}, new double[] {ny, -ny}, 0, before, after);
    }

    /**
     * An edge of a chain as a line that is solid on both sides.
     *
     * @param share half the line's thickness, as a share of its length
     */
    public Outline asLine(double share) {
        return of(cornerX, cornerY, 2 * share * halfLength());
    }

    private Outline(
            double[] cornerX,
            double[] cornerY,
            double[] normalX,
            double[] normalY,
            double radius,
            EdgeEnd before,
            EdgeEnd after) {
        this.before = before;
        this.after = after;
        this.cornerX = cornerX;
        this.cornerY = cornerY;
        this.normalX = normalX;
        this.normalY = normalY;
        this.radius = radius;
        coreReach = farthestCorner();
        innerRadius = nearestEdge();
        smallestWidth = before == null ? narrowest() + 2 * radius : Double.POSITIVE_INFINITY;
        isBox = findBox();
    }

    /** Number of the core's corners. */
    public int corners() {
        return cornerX.length;
    }

    /** Number of edges: as many as corners; 0 for a disc. */
    public int edges() {
        return normalX.length;
    }

    /** A corner's x, m; corners are counter-clockwise. */
    public double cornerX(int i) {
        return cornerX[i];
    }

    /** A corner's y, m, up; corners are counter-clockwise. */
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

    /** Distance in m between the core and the outline, 0 or more. */
    public double radius() {
        return radius;
    }

    /** Distance in m from the centre of mass to the farthest point of the outline. */
    public double boundingRadius() {
        return coreReach + radius;
    }

    /**
     * Speed at which turning moves the outline, m per rad: the distance to the core's farthest
     * corner, 0 for a disc.
     */
    public double sweepRadius() {
        return coreReach;
    }

    /**
     * Distance in m from the centre of mass to the core's nearest edge. Where the centre of mass
     * lies outside the core, it is minus its distance from the core.
     */
    public double innerRadius() {
        return innerRadius;
    }

    /**
     * Smallest distance in m between two parallel lines that enclose the outline; infinite for a
     * chain's edge, since the matter behind it has no thickness.
     */
    public double smallestWidth() {
        return smallestWidth;
    }

    /** Whether this is a disc centred on the centre of mass, which turning does not change. */
    public boolean isCentredDisc() {
        return coreReach == 0;
    }

    /**
     * Whether this is an edge of a chain, which stops only what is in front of its first normal.
     */
    public boolean isEdge() {
        return before != null;
    }

    /** Whether other parts of the body cover any edge. */
    public boolean hasInner() {
        return inner != null;
    }

    /**
     * Whether other parts of the body cover an edge all along, so that nothing leaves through it.
     */
    public boolean isInner(int edge) {
        return inner != null && inner.isCovered(edge);
    }

    /**
     * Where a unit direction out of this part, in the shape's own frame, leads: {@link #OUT}, or
     * {@link #INSIDE} where another part covers the edge. Any other number names a corner at which
     * another part continues the surface; the direction passes that surface by an angle whose sine
     * is greater than {@code sine}.
     */
    public int leads(double x, double y, double sine) {
        return inner == null ? OUT : inner.leads(x, y, sine);
    }

    /** The outermost direction at a corner that {@link #leads} told. */
    public double outermostX(int corner) {
        return inner.outermostX(corner);
    }

    /** The outermost direction at a corner that {@link #leads} told. */
    public double outermostY(int corner) {
        return inner.outermostY(corner);
    }

    /** Whether the part that begins at a corner that {@link #leads} told rises there. */
    public boolean rises(int corner) {
        return inner.rises(corner);
    }

    /**
     * Smallest width of the body at this part, m. Where another part covers an edge, it is measured
     * through that part. Infinite if other parts surround this one.
     */
    double openWidth() {
        return inner == null ? smallestWidth : inner.openWidth();
    }

    /** Notes, once and before the outline is shared, which edges other parts cover. */
    void noteInner(CoveredEdges edges) {
        inner = edges;
    }

    /** Half the length of a chain's edge, m. */
    public double halfLength() {
        double dx = cornerX[1] - cornerX[0];
        double dy = cornerY[1] - cornerY[0];
        return Math.sqrt(dx * dx + dy * dy) / 2;
    }

    /** The neighbour at the first corner of a chain's edge. */
    public EdgeEnd before() {
        return before;
    }

    /** The neighbour at the second corner of a chain's edge. */
    public EdgeEnd after() {
        return after;
    }

    /** Whether the first corner of a chain's edge is convex; an open end is. */
    public boolean isConvexBefore() {
        return bendBefore() > STRAIGHT;
    }

    /** Whether the second corner of a chain's edge is convex; an open end is. */
    public boolean isConvexAfter() {
        return bendAfter() > STRAIGHT;
    }

    /** Sine of the left turn from the previous edge to this one. */
    private double bendBefore() {
        return before.normalX() * normalY[0] - before.normalY() * normalX[0];
    }

    private double bendAfter() {
        return normalX[0] * after.normalY() - normalY[0] * after.normalX();
    }

    /** Whether the core is a single point, not necessarily the centre of mass. */
    public boolean isDisc() {
        return cornerX.length == 1;
    }

    /**
     * Whether this is a sharp rectangle, centred, with sides along its own axes and the lower left
     * corner first. If so, corner 2 is (half the width, half the height).
     */
    public boolean isBox() {
        return isBox;
    }

    /**
     * Writes the axis-aligned bounds at a pose.
     *
     * @param x centre of mass, m
     * @param y centre of mass, m
     * @param cos cosine of the angle
     * @param sin sine of the angle
     * @param out receives the bounds, m
     */
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
        out.set(x + minX - radius, y + minY - radius, x + maxX + radius, y + maxY + radius);
    }

    /**
     * Depth of a point inside the outline, m, negative outside. Beyond a corner of a sharp outline
     * it is the smallest depth behind the lines of the edges, whose amount is less than the
     * distance. All points behind a chain's edge are inside.
     *
     * @param x relative to the centre of mass, in the shape's own frame, m
     * @param y relative to the centre of mass, in the shape's own frame, m
     */
    public double depth(double x, double y) {
        if (isEdge()) {
            return depthBehindEdge(x, y);
        }
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < normalX.length; i++) {
            double front = normalX[i] * (x - cornerX[i]) + normalY[i] * (y - cornerY[i]);
            least = Math.min(least, -front);
        }
        boolean isOutsideOfCore = isDisc() || least < 0 || cornerX.length == 2;
        return radius > 0 && isOutsideOfCore ? radius - distanceToCore(x, y) : least + radius;
    }

    private double depthBehindEdge(double x, double y) {
        double behind = -(normalX[0] * (x - cornerX[0]) + normalY[0] * (y - cornerY[0]));
        double fromStart = normalX[0] * (y - cornerY[0]) - normalY[0] * (x - cornerX[0]);
        double fromEnd = normalX[0] * (cornerY[1] - y) - normalY[0] * (cornerX[1] - x);
        return Math.min(behind, Math.min(fromStart, fromEnd));
    }

    /** Distance from the core of a point outside it, m. */
    private double distanceToCore(double x, double y) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < cornerX.length; i++) {
            int next = i + 1 == cornerX.length ? 0 : i + 1;
            double ex = cornerX[next] - cornerX[i];
            double ey = cornerY[next] - cornerY[i];
            double dx = x - cornerX[i];
            double dy = y - cornerY[i];
            double square = ex * ex + ey * ey;
            double along = square > 0 ? (dx * ex + dy * ey) / square : 0;
            double share = Math.max(0, Math.min(1, along));
            double awayX = dx - share * ex;
            double awayY = dy - share * ey;
            least = Math.min(least, awayX * awayX + awayY * awayY);
        }
        return Math.sqrt(least);
    }

    private double farthestCorner() {
        double most = 0;
        for (int i = 0; i < cornerX.length; i++) {
            most = Math.max(most, cornerX[i] * cornerX[i] + cornerY[i] * cornerY[i]);
        }
        return Math.sqrt(most);
    }

    private double nearestEdge() {
        double least = normalX.length == 0 ? 0 - coreReach : Double.POSITIVE_INFINITY;
        for (int i = 0; i < normalX.length; i++) {
            least = Math.min(least, normalX[i] * cornerX[i] + normalY[i] * cornerY[i]);
        }
        return least < 0 && normalX.length > 0 ? -distanceToCore(0, 0) : least;
    }

    /** The smallest width of a convex polygon is across one of its edges (rotating calipers). */
    private double narrowest() {
        double least = normalX.length == 0 ? 0 : Double.POSITIVE_INFINITY;
        for (int i = 0; i < normalX.length; i++) {
            least = Math.min(least, extent(i));
        }
        return least;
    }

    /** How far the core extends from an edge, m. */
    double extent(int edge) {
        double deepest = 0;
        for (int j = 0; j < cornerX.length; j++) {
            double across =
                    normalX[edge] * (cornerX[edge] - cornerX[j])
                            + normalY[edge] * (cornerY[edge] - cornerY[j]);
            deepest = Math.max(deepest, across);
        }
        return deepest;
    }

    private boolean findBox() {
        if (cornerX.length != 4 || radius > 0) {
            return false;
        }
        double w = cornerX[2];
        double h = cornerY[2];
        return Arrays.equals(cornerX, new double[] {-w, w, w, -w})
                && Arrays.equals(cornerY, new double[] {-h, -h, h, h});
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Outline outline
                && radius == outline.radius
                && Arrays.equals(cornerX, outline.cornerX)
                && Arrays.equals(cornerY, outline.cornerY)
                && Objects.equals(before, outline.before)
                && Objects.equals(after, outline.after);
    }

    @Override
    public int hashCode() {
        int corners = 31 * Arrays.hashCode(cornerX) + Arrays.hashCode(cornerY);
        return radius > 0 ? 31 * corners + Double.hashCode(radius) : corners;
    }

    @Override
    public String toString() {
        return "Outline[" + cornerX.length + " corners, radius " + radius + " m]";
    }

    /** Writes the common bounds of all outlines of a body, of which there is at least one. */
    static void bounds(Outline[] outlines, double x, double y, double cos, double sin, Aabb out) {
        Aabb one = new Aabb();
        outlines[0].bounds(x, y, cos, sin, out);
        for (int i = 1; i < outlines.length; i++) {
            outlines[i].bounds(x, y, cos, sin, one);
            out.enclose(one);
        }
    }
}
