package rigibo.backend.collision.distance;

import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.geometry.Length;
import rigibo.backend.geometry.Outline;

/** Tests whether a shape at a pose contains a point, and where a ray enters it. */
public final class PointAndRay {

    /** Returned when a ray does not enter a shape. */
    public static final double MISS = Double.POSITIVE_INFINITY;

    /** Outward unit normal where the last ray entered. */
    public double normalX;

    public double normalY;

    /** Nearest point of the shape in the last call of {@link #nearest}, in the world, m. */
    public double pointX;

    public double pointY;

    /** Nearest point of the core, in the shape's frame, m. */
    private double coreX;

    private double coreY;

    /**
     * Whether a world point (m) lies inside or on the outline; an edge of a chain contains none.
     */
    public boolean holds(Outline shape, Pose pose, double x, double y) {
        double localX = pose.cos * (x - pose.x) + pose.sin * (y - pose.y);
        double localY = pose.cos * (y - pose.y) - pose.sin * (x - pose.x);
        if (shape.isEdge()) {
            return false;
        }
        if (shape.isDisc()) {
            double radius = shape.radius();
            double dx = localX - shape.cornerX(0);
            double dy = localY - shape.cornerY(0);
            return dx * dx + dy * dy <= radius * radius;
        }
        return shape.depth(localX, localY) >= 0;
    }

    /**
     * The fraction of the segment from one world point to another at which the ray enters the
     * shape, or {@link #MISS}; a ray that starts inside does not enter.
     */
    public double enters(
            Outline shape, Pose pose, double fromX, double fromY, double toX, double toY) {
        double x = pose.cos * (fromX - pose.x) + pose.sin * (fromY - pose.y);
        double y = pose.cos * (fromY - pose.y) - pose.sin * (fromX - pose.x);
        double dx = pose.cos * (toX - fromX) + pose.sin * (toY - fromY);
        double dy = pose.cos * (toY - fromY) - pose.sin * (toX - fromX);
        double fraction = enters(shape, x, y, dx, dy);
        double nx = normalX;
        normalX = pose.cos * nx - pose.sin * normalY;
        normalY = pose.sin * nx + pose.cos * normalY;
        return fraction;
    }

    /**
     * Distance in m of a world point from a shape, 0 inside; {@link #pointX} and {@link #pointY}
     * then hold the nearest point of the shape.
     */
    public double nearest(Outline shape, Pose pose, double x, double y) {
        double localX = pose.cos * (x - pose.x) + pose.sin * (y - pose.y);
        double localY = pose.cos * (y - pose.y) - pose.sin * (x - pose.x);
        pointX = x;
        pointY = y;
        if (!shape.isEdge() && shape.depth(localX, localY) >= 0) {
            return 0;
        }
        double distance = nearestOfCore(shape, localX, localY);
        double share = distance > 0 ? shape.radius() / distance : 0;
        double nearX = coreX + share * (localX - coreX);
        double nearY = coreY + share * (localY - coreY);
        pointX = pose.worldX(nearX, nearY);
        pointY = pose.worldY(nearX, nearY);
        return distance - shape.radius();
    }

    private double nearestOfCore(Outline shape, double x, double y) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < shape.corners(); i++) {
            int next = i + 1 == shape.corners() ? 0 : i + 1;
            double ex = shape.cornerX(next) - shape.cornerX(i);
            double ey = shape.cornerY(next) - shape.cornerY(i);
            double dx = x - shape.cornerX(i);
            double dy = y - shape.cornerY(i);
            double square = ex * ex + ey * ey;
            double along = square > 0 ? (dx * ex + dy * ey) / square : 0;
            double share = Math.max(0, Math.min(1, along));
            double awayX = dx - share * ex;
            double awayY = dy - share * ey;
            double away = awayX * awayX + awayY * awayY;
            if (away < least) {
                least = away;
                coreX = shape.cornerX(i) + share * ex;
                coreY = shape.cornerY(i) + share * ey;
            }
        }
        return Math.sqrt(least);
    }

    private double enters(Outline shape, double x, double y, double dx, double dy) {
        if (shape.isDisc()) {
            return entersDisc(shape.radius(), x - shape.cornerX(0), y - shape.cornerY(0), dx, dy);
        }
        if (shape.isEdge()) {
            normalX = shape.normalX(0);
            normalY = shape.normalY(0);
            return entersEdge(shape, 0, x, y, dx, dy);
        }
        return shape.radius() > 0
                ? entersRounded(shape, x, y, dx, dy)
                : entersPolygon(shape, x, y, dx, dy);
    }

    /**
     * The fraction at which a ray enters a rounded outline: at the first of its edges and round
     * corners.
     */
    private double entersRounded(Outline outline, double x, double y, double dx, double dy) {
        if (outline.depth(x, y) > 0) {
            return MISS;
        }
        double first = MISS;
        double firstX = 0;
        double firstY = 0;
        for (int i = 0; i < outline.corners(); i++) {
            double at =
                    entersDisc(
                            outline.radius(),
                            x - outline.cornerX(i),
                            y - outline.cornerY(i),
                            dx,
                            dy);
            if (at < first) {
                first = at;
                firstX = normalX;
                firstY = normalY;
            }
            at = entersEdge(outline, i, x, y, dx, dy);
            if (at < first) {
                first = at;
                firstX = outline.normalX(i);
                firstY = outline.normalY(i);
            }
        }
        normalX = firstX;
        normalY = firstY;
        return first;
    }

    private static double entersEdge(
            Outline outline, int edge, double x, double y, double dx, double dy) {
        double nx = outline.normalX(edge);
        double ny = outline.normalY(edge);
        double speed = nx * dx + ny * dy;
        double at = -(front(outline, edge, x, y) - outline.radius()) / speed;
        if (!(speed < 0 && at >= 0 && at <= 1)) {
            return MISS;
        }
        int end = edge + 1 == outline.corners() ? 0 : edge + 1;
        double px = x + at * dx;
        double py = y + at * dy;
        boolean isOver =
                nx * (py - outline.cornerY(edge)) - ny * (px - outline.cornerX(edge)) >= 0
                        && nx * (py - outline.cornerY(end)) - ny * (px - outline.cornerX(end)) <= 0;
        return isOver ? at : MISS;
    }

    /**
     * The smaller root of |p + t·d|² = r² along the unit vector d. The discriminant uses p × d, the
     * distance at which the ray passes the centre, because (p·d)² − (p² − r²) would lose a small
     * disc far from the ray's start. The normal is computed from its components along and across
     * the ray, because p + t·d would lose its direction from the centre in the same way.
     */
    private double entersDisc(double radius, double x, double y, double dx, double dy) {
        double length = Length.hypot(dx, dy);
        double ux = dx / length;
        double uy = dy / length;
        double ahead = -(x * ux + y * uy);
        double beside = x * uy - y * ux;
        double discriminant = (radius - beside) * (radius + beside);
        boolean isInside = Length.hypot(x, y) < radius;
        if (isInside || !(ahead > 0) || !(discriminant >= 0)) {
            return MISS;
        }
        double root = Math.sqrt(discriminant);
        normalX = (beside * uy - root * ux) / radius;
        normalY = (-beside * ux - root * uy) / radius;
        double fraction = way(ahead, root, x * x + y * y - radius * radius) / length;
        return fraction <= 1 ? fraction : MISS;
    }

    /**
     * The smaller root of t² − 2·ahead·t + c, in the form that avoids subtracting two nearly equal
     * numbers.
     */
    private static double way(double ahead, double root, double c) {
        return ahead > 2 * root ? ahead - root : c / (ahead + root);
    }

    /** Clips the ray by every edge's line: it enters at the last line that it crosses inwards. */
    private double entersPolygon(Outline polygon, double x, double y, double dx, double dy) {
        double in = -1;
        double out = 1;
        for (int i = 0; i < polygon.corners(); i++) {
            double distance = front(polygon, i, x, y);
            double speed = polygon.normalX(i) * dx + polygon.normalY(i) * dy;
            if (speed == 0 && distance > 0) {
                return MISS;
            }
            double at = -distance / speed;
            if (speed < 0 && at > in) {
                in = at;
                normalX = polygon.normalX(i);
                normalY = polygon.normalY(i);
            } else if (speed > 0) {
                out = Math.min(out, at);
            }
        }
        return in >= 0 && in <= out ? in : MISS;
    }

    private static double front(Outline polygon, int edge, double x, double y) {
        return polygon.normalX(edge) * (x - polygon.cornerX(edge))
                + polygon.normalY(edge) * (y - polygon.cornerY(edge));
    }
}
