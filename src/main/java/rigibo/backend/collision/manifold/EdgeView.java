package rigibo.backend.collision.manifold;

import rigibo.backend.geometry.EdgeEnd;
import rigibo.backend.geometry.Outline;

/**
 * The corners of a core in the frame of an edge of a chain. The edge lies on the first axis, with
 * its middle at the origin, its start on the right and its end on the left; the second axis points
 * into the air. In this frame a mirrored scene is mirrored to the bit.
 */
final class EdgeView {

    /**
     * Sine of the angle by which a direction may lie outside the range in which a corner pushes.
     */
    static final double FLAT = 1e-4;

    /** Half the length of the edge, m. */
    double half;

    /** The core's corners: position along the edge, and height above it, m. */
    double[] along = new double[4];

    double[] above = new double[4];
    int corners;

    /** Number of the lowest corner, and the lowest and the greatest height, m. */
    int lowest;

    double least;
    double most;

    /** The lowest height of a corner over or under the edge, m; infinite if there is none. */
    double leastOver;

    /** Results of {@link #lookFrom}: whether the end of the edge is inside the core. */
    boolean isInside;

    /**
     * Distance of that end from the core, m, negative inside; the direction to the core; and
     * whether the nearest point is inside a face.
     */
    double distance;

    double directionX;
    double directionY;
    boolean isOfFace;

    /** The corner at which the nearest side begins. */
    private int sideFrom;

    private Outline edge;
    private double midX;
    private double midY;
    private double ux;
    private double uy;

    /** Half the length, m, within which a corner counts as over the edge. */
    private double within;

    /** Transforms the core of an outline into the frame of an edge. */
    void look(Outline from, Pose edgePose, Outline core, Pose corePose, double beside) {
        edge = from;
        double nx = edge.normalX(0);
        double ny = edge.normalY(0);
        ux = ny;
        uy = -nx;
        midX = (edge.cornerX(0) + edge.cornerX(1)) / 2;
        midY = (edge.cornerY(0) + edge.cornerY(1)) / 2;
        half =
                (ux * (edge.cornerX(0) - edge.cornerX(1))
                                + uy * (edge.cornerY(0) - edge.cornerY(1)))
                        / 2;
        within = half + beside;
        double dx = corePose.x - edgePose.x;
        double dy = corePose.y - edgePose.y;
        double x = edgePose.cos * dx + edgePose.sin * dy - midX;
        double y = edgePose.cos * dy - edgePose.sin * dx - midY;
        double cos = edgePose.cos * corePose.cos + edgePose.sin * corePose.sin;
        double sin = edgePose.cos * corePose.sin - edgePose.sin * corePose.cos;
        corners = core.corners();
        if (along.length < corners) {
            along = new double[corners];
            above = new double[corners];
        }
        least = Double.POSITIVE_INFINITY;
        most = Double.NEGATIVE_INFINITY;
        leastOver = Double.POSITIVE_INFINITY;
        for (int i = 0; i < corners; i++) {
            double px = x + (cos * core.cornerX(i) - sin * core.cornerY(i));
            double py = y + (sin * core.cornerX(i) + cos * core.cornerY(i));
            along[i] = ux * px + uy * py;
            above[i] = nx * px + ny * py;
            if (above[i] < least) {
                least = above[i];
                lowest = i;
            }
            most = Math.max(most, above[i]);
            if (isOver(i)) {
                leastOver = Math.min(leastOver, above[i]);
            }
        }
    }

    /** Lower bound on the distance between core and edge, m. */
    double leastDistance() {
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < corners; i++) {
            left = Math.min(left, along[i]);
            right = Math.max(right, along[i]);
        }
        double aside = Math.max(0, Math.max(left - half, -half - right));
        double off = Math.max(0, Math.max(least, -most));
        return Math.sqrt(aside * aside + off * off);
    }

    /** Whether a corner of the core lies over or under the edge, not beside it. */
    boolean isOver(int i) {
        return Math.abs(along[i]) <= within;
    }

    /** Mean position of the core's corners along the edge, then their mean height, m. */
    double centreAlong() {
        return mean(along);
    }

    double centreAbove() {
        return mean(above);
    }

    private double mean(double[] values) {
        double sum = 0;
        for (int i = 0; i < corners; i++) {
            sum += values[i];
        }
        return sum / corners;
    }

    /** Position of an end of the edge along it, m; the start is on the right. */
    double end(boolean isStart) {
        return isStart ? half : -half;
    }

    /**
     * Finds the point of the core nearest to an end of the edge. If that end is inside the core, it
     * is the nearest face along whose normal the end can push.
     */
    void lookFrom(boolean isStart) {
        double x = end(isStart);
        isInside = corners > 2;
        isOfFace = false;
        double leastSquare = Double.POSITIVE_INFINITY;
        int segments = corners > 2 ? corners : 1;
        for (int i = 0; i < segments; i++) {
            int next = i + 1 < corners ? i + 1 : 0;
            double ex = along[next] - along[i];
            double ey = above[next] - above[i];
            double px = x - along[i];
            double py = -above[i];
            isInside &= ex * py - ey * px >= 0;
            double square = ex * ex + ey * ey;
            double share = square > 0 ? (px * ex + py * ey) / square : 0;
            double held = Math.max(0, Math.min(1, share));
            double awayX = held * ex - px;
            double awayY = held * ey - py;
            double away = awayX * awayX + awayY * awayY;
            if (away < leastSquare) {
                leastSquare = away;
                directionX = awayX;
                directionY = awayY;
                isOfFace = held == share && square > 0;
                sideFrom = i;
            }
        }
        distance = Math.sqrt(leastSquare);
        if (isInside || distance == 0) {
            lookOut(isStart, x, true);
        } else {
            directionX /= distance;
            directionY /= distance;
        }
    }

    private void lookOut(boolean isStart, double x, boolean isPushed) {
        isInside = true;
        isOfFace = true;
        distance = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < corners && corners > 1; i++) {
            int next = i + 1 < corners ? i + 1 : 0;
            double ex = along[next] - along[i];
            double ey = above[next] - above[i];
            double length = Math.sqrt(ex * ex + ey * ey);
            double inX = -ey / length;
            double inY = ex / length;
            double depth = inX * (x - along[i]) - inY * above[i];
            boolean isWay = !isPushed || mayPush(isStart, inX, inY);
            if (-depth > distance && isWay) {
                distance = -depth;
                directionX = inX;
                directionY = inY;
                sideFrom = i;
            }
        }
    }

    /** Left end of the side that {@link #lookFrom} found last. */
    int sideLeft() {
        int to = sideFrom + 1 < corners ? sideFrom + 1 : 0;
        return along[sideFrom] < along[to] ? sideFrom : to;
    }

    /** Right end of the side that {@link #lookFrom} found last. */
    int sideRight() {
        int to = sideFrom + 1 < corners ? sideFrom + 1 : 0;
        return along[sideFrom] < along[to] ? to : sideFrom;
    }

    /** Whether the chain is convex at an end of the edge. */
    boolean isConvex(boolean isStart) {
        return isStart ? edge.isConvexBefore() : edge.isConvexAfter();
    }

    EdgeEnd beyond(boolean isStart) {
        return isStart ? edge.before() : edge.after();
    }

    /**
     * Whether a convex corner pushes along a direction: one between the normals of its two edges.
     */
    boolean mayPush(boolean isStart, double x, double y) {
        EdgeEnd beyond = beyond(isStart);
        double bx = ux * beyond.normalX() + uy * beyond.normalY();
        double by = edge.normalX(0) * beyond.normalX() + edge.normalY(0) * beyond.normalY();
        double turn = isStart ? bx * y - by * x : x * by - y * bx;
        double own = isStart ? x : -x;
        return isConvex(isStart) && own >= -FLAT && turn >= -FLAT && x * bx + y * (1 + by) > 0;
    }

    /**
     * Finds the point of the core nearest to a convex end of the edge, or the shortest way out if
     * the end is inside; returns whether that way leads beyond the normal of the next edge, and so
     * to the far side of the end.
     */
    boolean leadsBeyond(boolean isStart) {
        lookFrom(isStart);
        if (isInside) {
            lookOut(isStart, end(isStart), false);
        }
        EdgeEnd beyond = beyond(isStart);
        double bx = ux * beyond.normalX() + uy * beyond.normalY();
        double by = edge.normalX(0) * beyond.normalX() + edge.normalY(0) * beyond.normalY();
        double turn = bx * directionY - by * directionX;
        boolean isPast = isStart ? turn < 0 : turn > 0;
        return isPast && (directionY < 0 || directionX * bx + directionY * by > 0);
    }

    /** Lowest height of the core beyond an end of the edge, m; infinite if no corner is there. */
    double leastBeyond(boolean isStart) {
        double lowest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < corners; i++) {
            double past = isStart ? along[i] : -along[i];
            if (past > within) {
                lowest = Math.min(lowest, above[i]);
            }
        }
        return lowest;
    }

    /** Whether a direction from an end of the edge leads into the air. */
    boolean isInAir(boolean isStart, double x, double y) {
        EdgeEnd beyond = beyond(isStart);
        double bx = ux * beyond.normalX() + uy * beyond.normalY();
        double by = edge.normalX(0) * beyond.normalX() + edge.normalY(0) * beyond.normalY();
        boolean isBefore = x * bx + y * by > 0;
        boolean isAbove = y > 0;
        if (beyond.isOpen()) {
            return isAbove;
        }
        return isConvex(isStart) ? isAbove || isBefore : isAbove && isBefore;
    }

    /** Whether the edge passes through the core. */
    boolean isPierced() {
        if (corners == 1) {
            return false;
        }
        double left = Double.POSITIVE_INFINITY;
        double right = Double.NEGATIVE_INFINITY;
        int segments = corners > 2 ? corners : 1;
        for (int i = 0; i < segments; i++) {
            int next = i + 1 < corners ? i + 1 : 0;
            if (above[i] >= 0 != above[next] >= 0) {
                double share = above[i] / (above[i] - above[next]);
                double at = along[i] + share * (along[next] - along[i]);
                left = Math.min(left, at);
                right = Math.max(right, at);
            }
        }
        return left <= half && right >= -half;
    }

    /** Adds a contact point with a gap in m, given in the frame of the edge. */
    void add(Pose edgePose, double s, double h, double gap, int name, Manifold out) {
        double x = midX + s * ux + h * edge.normalX(0);
        double y = midY + s * uy + h * edge.normalY(0);
        out.add(edgePose.worldX(x, y), edgePose.worldY(x, y), gap, name);
    }

    /** Sets the normal, given in the frame of the edge. */
    void normal(Pose edgePose, double s, double h, NormalSource source, Manifold out) {
        out.normal(s * ux + h * edge.normalX(0), s * uy + h * edge.normalY(0), source);
        out.turn(edgePose);
    }
}
