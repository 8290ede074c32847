package rigibo.backend.collision.manifold;

import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Shape;

/**
 * The corners of a core in the world, its radius, and a plain computation of the distance of two.
 */
public final class WorldOutline {

    private final double[] x;
    private final double[] y;
    private final double radius;

    public WorldOutline(Shape shape, Pose pose) {
        Outline polygon = shape.outline(0);
        radius = polygon.radius();
        x = new double[polygon.corners()];
        y = new double[polygon.corners()];
        for (int i = 0; i < x.length; i++) {
            x[i] = pose.x + pose.cos * polygon.cornerX(i) - pose.sin * polygon.cornerY(i);
            y[i] = pose.y + pose.sin * polygon.cornerX(i) + pose.cos * polygon.cornerY(i);
        }
    }

    /** The distance, or in overlap minus the shortest displacement that parts the two, m. */
    public static double gap(WorldOutline a, WorldOutline b) {
        double apart = Math.max(farthestFace(a, b), farthestFace(b, a));
        double gap = apart <= 0 ? apart : Math.min(nearestCorner(a, b), nearestCorner(b, a));
        return gap - a.radius - b.radius;
    }

    /** Extent along a unit direction, m. */
    public double reach(double dx, double dy) {
        return coreReach(dx, dy) + radius;
    }

    private double coreReach(double dx, double dy) {
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < x.length; i++) {
            most = Math.max(most, x[i] * dx + y[i] * dy);
        }
        return most;
    }

    private static double farthestFace(WorldOutline a, WorldOutline b) {
        double farthest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < a.x.length; i++) {
            int next = (i + 1) % a.x.length;
            double nx = a.y[next] - a.y[i];
            double ny = a.x[i] - a.x[next];
            double length = Math.hypot(nx, ny);
            double front = nx * a.x[i] + ny * a.y[i];
            farthest = Math.max(farthest, (-b.coreReach(-nx, -ny) - front) / length);
        }
        return farthest;
    }

    /** Distance from any corner of one to any edge of the other, m. */
    private static double nearestCorner(WorldOutline a, WorldOutline b) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < a.x.length; i++) {
            for (int j = 0; j < b.x.length; j++) {
                int next = (j + 1) % b.x.length;
                double ex = b.x[next] - b.x[j];
                double ey = b.y[next] - b.y[j];
                double px = a.x[i] - b.x[j];
                double py = a.y[i] - b.y[j];
                double along = (px * ex + py * ey) / (ex * ex + ey * ey);
                double inside = Math.max(0, Math.min(1, along));
                least = Math.min(least, Math.hypot(px - inside * ex, py - inside * ey));
            }
        }
        return least;
    }
}
