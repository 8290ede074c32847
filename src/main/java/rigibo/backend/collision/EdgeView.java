package rigibo.backend.collision;

import rigibo.backend.geometry.EdgeEnd;
import rigibo.backend.geometry.Outline;

/**
 * A core as it is seen from an edge of a chain: the edge lies along the first axis about the
 * origin, the air is up the second, and the edge begins to the right and ends to the left. So the
 * picture of a mirrored scene is the mirrored picture, to the bit.
 */
final class EdgeView {

    /** Sine of the angle by which a direction may lie beside those that a corner pushes along. */
    static final double FLAT = 1e-4;

    /** Half the length of the edge, m. */
    double half;

    /** The corners of the core along the edge and above it, m. */
    double[] along = new double[4];

    double[] above = new double[4];
    int corners;

    /** The corner that lies lowest, and how low and how high the core reaches, m. */
    int lowest;

    double least;
    double most;

    /** The least height of a corner that lies over the edge, m; infinite where none does. */
    double leastOver;

    /** What {@link #lookFrom} found: whether the core holds the corner, */
    boolean isInside;

    /**
     * how far away it is, m, negative inside, in which direction, and whether in a face's midst.
     */
    double distance;

    double directionX;
    double directionY;
    boolean isOfFace;

    /** The corner with which the nearest side begins. */
    private int sideFrom;

    private Outline edge;
    private double midX;
    private double midY;
    private double ux;
    private double uy;

    /** Half the length beside the edge within which a corner counts as over it, m. */
    private double within;

    /** Looks at the core of an outline from an edge. */
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

    /** A bound of how near the core is to the edge, m: what lies around the core is no farther. */
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

    /** The middle of the core's corners along the edge and above it, m. */
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

    /** Where an end of the edge lies along it, m: the start is at the right. */
    double end(boolean isStart) {
        return isStart ? half : -half;
    }

    /**
     * Looks from an end of the edge for the nearest point of the core. From inside the core it
     * takes the way out through the nearest face along whose normal the corner may be pushed.
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
            lookOut(isStart, x);
        } else {
            directionX /= distance;
            directionY /= distance;
        }
    }

    private void lookOut(boolean isStart, double x) {
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
            if (-depth > distance && mayPush(isStart, inX, inY)) {
                distance = -depth;
                directionX = inX;
                directionY = inY;
                sideFrom = i;
            }
        }
    }

    /** The left end of the side that is nearest to where {@link #lookFrom} looked from last. */
    int sideLeft() {
        int to = sideFrom + 1 < corners ? sideFrom + 1 : 0;
        return along[sideFrom] < along[to] ? sideFrom : to;
    }

    /** Its right end. */
    int sideRight() {
        int to = sideFrom + 1 < corners ? sideFrom + 1 : 0;
        return along[sideFrom] < along[to] ? to : sideFrom;
    }

    /** Whether matter ends in a corner at an end of the edge. */
    boolean isConvex(boolean isStart) {
        return isStart ? edge.isConvexBefore() : edge.isConvexAfter();
    }

    EdgeEnd beyond(boolean isStart) {
        return isStart ? edge.before() : edge.after();
    }

    /** Whether a corner of matter pushes along a direction: one between the normals beside it. */
    boolean mayPush(boolean isStart, double x, double y) {
        EdgeEnd beyond = beyond(isStart);
        double bx = ux * beyond.normalX() + uy * beyond.normalY();
        double by = edge.normalX(0) * beyond.normalX() + edge.normalY(0) * beyond.normalY();
        double turn = isStart ? bx * y - by * x : x * by - y * bx;
        double own = isStart ? x : -x;
        return isConvex(isStart) && own >= -FLAT && turn >= -FLAT && x * bx + y * (1 + by) > 0;
    }

    /** How low the core reaches beyond an end of the edge, m; infinite where it does not. */
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

    /** Whether the edge goes through the core. */
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

    /** Adds a point of contact, seen from the edge, with a gap in m. */
    void add(Pose edgePose, double s, double h, double gap, int name, Manifold out) {
        double x = midX + s * ux + h * edge.normalX(0);
        double y = midY + s * uy + h * edge.normalY(0);
        out.add(edgePose.worldX(x, y), edgePose.worldY(x, y), gap, name);
    }

    /** States a normal that is seen from the edge. */
    void normal(Pose edgePose, double s, double h, NormalSource source, Manifold out) {
        out.normal(s * ux + h * edge.normalX(0), s * uy + h * edge.normalY(0), source);
        out.turn(edgePose);
    }
}
