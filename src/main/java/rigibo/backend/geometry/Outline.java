package rigibo.backend.geometry;

import java.util.Arrays;
import java.util.Objects;

/**
 * The outline of a convex shape as collisions see it: a core of corners, and a radius at which the
 * outline goes round the core. The core of a disc is one point, that of a capsule two, that of a
 * polygon its corners, with a radius of 0 where it is not rounded. All places are seen from the
 * body's centre of mass. Immutable.
 *
 * <pre>{@code
 * Outline pill = new Capsule(0.5, 0.2).outline();
 * System.out.println(pill.corners() + " corners, round by " + pill.radius() + " m"); // 2, 0.2 m
 * }</pre>
 */
public final class Outline {

    /** Sine of the turn between two edges of a chain up to which they are one straight line. */
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

    /** What lies beyond the ends of a chain's edge; null of all others. */
    private final EdgeEnd before;

    private final EdgeEnd after;

    /** A disc about the centre of mass. */
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
     * @param share half of what it is thick, as a share of its length
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

    /** Number of edges: as many as corners, and none of a disc. */
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

    /** The distance in m at which the outline goes round the core, 0 or more. */
    public double radius() {
        return radius;
    }

    /** Distance in m from the centre of mass to the farthest point of the outline. */
    public double boundingRadius() {
        return coreReach + radius;
    }

    /** How far turning moves the outline, m per rad: to the core's farthest corner, 0 of a disc. */
    public double sweepRadius() {
        return coreReach;
    }

    /**
     * Distance in m from the centre of mass to the core's nearest edge, minus that to the core
     * where it lies outside: the core reaches as far in every direction.
     */
    public double innerRadius() {
        return innerRadius;
    }

    /**
     * Smallest width in m between two parallel lines that hold the outline; infinite of a chain's
     * edge, behind which matter is as thick as may be.
     */
    public double smallestWidth() {
        return smallestWidth;
    }

    /** Whether this is a disc about the centre of mass, whose outline stays when it turns. */
    public boolean isCentredDisc() {
        return coreReach == 0;
    }

    /** Whether this is an edge of a chain: solid in front of its first normal alone. */
    public boolean isEdge() {
        return before != null;
    }

    /** Half the length of a chain's edge, m. */
    public double halfLength() {
        double dx = cornerX[1] - cornerX[0];
        double dy = cornerY[1] - cornerY[0];
        return Math.sqrt(dx * dx + dy * dy) / 2;
    }

    /** What lies before the first corner of a chain's edge. */
    public EdgeEnd before() {
        return before;
    }

    /** What lies behind the second corner of a chain's edge. */
    public EdgeEnd after() {
        return after;
    }

    /** Whether matter ends in a corner where a chain's edge begins; so it does at an open end. */
    public boolean isConvexBefore() {
        return bendBefore() > STRAIGHT;
    }

    /** Whether matter ends in a corner where a chain's edge ends. */
    public boolean isConvexAfter() {
        return bendAfter() > STRAIGHT;
    }

    /** Sine of the turn to the left from the edge before to this one. */
    private double bendBefore() {
        return before.normalX() * normalY[0] - before.normalY() * normalX[0];
    }

    private double bendAfter() {
        return normalX[0] * after.normalY() - normalY[0] * after.normalX();
    }

    /** Whether the core is one point, wherever that is. */
    public boolean isDisc() {
        return cornerX.length == 1;
    }

    /**
     * Whether this is a sharp rectangle about its centre, with sides along its own axes and the
     * lower left corner first: then corner 2 holds half the width and half the height.
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
     * How deep a point lies inside, m, negative outside. Beyond a corner of a sharp outline it is
     * the least of the depths behind the edges' lines, which is more than its distance. Behind a
     * chain's edge all is inside.
     *
     * @param x seen from the centre of mass, in the shape's own frame, m
     * @param y likewise, m
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

    /** Distance of a point outside of the core from it, m. */
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

    /** A convex polygon is narrowest across one of its edges (rotating calipers). */
    private double narrowest() {
        double least = normalX.length == 0 ? 0 : Double.POSITIVE_INFINITY;
        for (int i = 0; i < normalX.length; i++) {
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

    /** Writes the bounds of all outlines of one body, of which there is at least one. */
    static void bounds(Outline[] outlines, double x, double y, double cos, double sin, Aabb out) {
        Aabb one = new Aabb();
        outlines[0].bounds(x, y, cos, sin, out);
        for (int i = 1; i < outlines.length; i++) {
            outlines[i].bounds(x, y, cos, sin, one);
            out.enclose(one);
        }
    }
}
