package rigibo.backend.collision;

import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;

/** Whether a posed shape holds a point, and where a ray enters it. */
public final class PointAndRay {

    /** Returned where a ray does not enter a shape. */
    public static final double MISS = Double.POSITIVE_INFINITY;

    /** Outward unit normal where the last ray entered. */
    public double normalX;

    public double normalY;

    /** Whether a point in world m lies inside or on the outline. */
    public boolean holds(Shape shape, Pose pose, double x, double y) {
        double localX = pose.cos * (x - pose.x) + pose.sin * (y - pose.y);
        double localY = pose.cos * (y - pose.y) - pose.sin * (x - pose.x);
        if (shape.kind() == ShapeKind.CIRCLE) {
            double radius = shape.boundingRadius();
            return localX * localX + localY * localY <= radius * radius;
        }
        return holds((Polygon) shape, localX, localY);
    }

    private static boolean holds(Polygon polygon, double x, double y) {
        for (int i = 0; i < polygon.corners(); i++) {
            if (front(polygon, i, x, y) > 0) {
                return false;
            }
        }
        return true;
    }

    /**
     * The fraction of the way from one world point to another at which the ray enters the shape, or
     * {@link #MISS}; a ray that starts inside does not enter.
     */
    public double enters(
            Shape shape, Pose pose, double fromX, double fromY, double toX, double toY) {
        double x = pose.cos * (fromX - pose.x) + pose.sin * (fromY - pose.y);
        double y = pose.cos * (fromY - pose.y) - pose.sin * (fromX - pose.x);
        double dx = pose.cos * (toX - fromX) + pose.sin * (toY - fromY);
        double dy = pose.cos * (toY - fromY) - pose.sin * (toX - fromX);
        double fraction =
                shape.kind() == ShapeKind.CIRCLE
                        ? entersDisc(shape.boundingRadius(), x, y, dx, dy)
                        : entersPolygon((Polygon) shape, x, y, dx, dy);
        double nx = normalX;
        normalX = pose.cos * nx - pose.sin * normalY;
        normalY = pose.sin * nx + pose.cos * normalY;
        return fraction;
    }

    /**
     * The smaller root of |p + t·d|² = r² along the unit vector d. The discriminant is written with
     * p × d, how far the ray passes the centre: (p·d)² − (p² − r²) would lose a small disc far from
     * the ray's start. So would the point p + t·d its direction from the centre: the normal is told
     * by its parts along and across the ray.
     */
    private double entersDisc(double radius, double x, double y, double dx, double dy) {
        double length = StrictMath.hypot(dx, dy);
        double ux = dx / length;
        double uy = dy / length;
        double ahead = -(x * ux + y * uy);
        double beside = x * uy - y * ux;
        double discriminant = (radius - beside) * (radius + beside);
        boolean isInside = StrictMath.hypot(x, y) < radius;
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
     * The smaller root of t² − 2·ahead·t + c; of two like numbers their difference is mostly lost.
     */
    private static double way(double ahead, double root, double c) {
        return ahead > 2 * root ? ahead - root : c / (ahead + root);
    }

    /** Clips the ray by every edge's line: it enters where the last of them lets it in. */
    private double entersPolygon(Polygon polygon, double x, double y, double dx, double dy) {
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

    private static double front(Polygon polygon, int edge, double x, double y) {
        return polygon.normalX(edge) * (x - polygon.cornerX(edge))
                + polygon.normalY(edge) * (y - polygon.cornerY(edge));
    }
}
