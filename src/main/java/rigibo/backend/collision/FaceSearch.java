package rigibo.backend.collision;

import rigibo.backend.geometry.Polygon;

/**
 * The face of a polygon that separates it farthest from another, or overlaps least (separating axis
 * theorem; S. Gottschalk, Separating Axis Theorem, 1996).
 */
final class FaceSearch {

    /** The face found, its separation in m, and the other polygon's corner nearest to it. */
    int face;

    double separation;
    int corner;

    /**
     * Searches all faces; true, without a result, as soon as one is farther than {@code reach} m
     * from the other polygon. The nearest corner walks around the other polygon as the face walks
     * around this one, so that n faces and m corners cost n + m evaluations (rotating calipers).
     */
    boolean isApart(Polygon polygon, CornersInFrame other, double reach) {
        double[] x = other.x;
        double[] y = other.y;
        int nearest = nearestTo(polygon.normalX(0), polygon.normalY(0), other);
        separation = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < polygon.corners(); i++) {
            double nx = polygon.normalX(i);
            double ny = polygon.normalY(i);
            double least = nx * x[nearest] + ny * y[nearest];
            int next = other.after(nearest);
            double following = nx * x[next] + ny * y[next];
            while (following < least) {
                least = following;
                nearest = next;
                next = other.after(nearest);
                following = nx * x[next] + ny * y[next];
            }
            double gap =
                    nx * (x[nearest] - polygon.cornerX(i)) + ny * (y[nearest] - polygon.cornerY(i));
            if (gap > separation) {
                if (gap > reach) {
                    return true;
                }
                separation = gap;
                face = i;
                corner = nearest;
            }
        }
        return false;
    }

    private static int nearestTo(double nx, double ny, CornersInFrame other) {
        int nearest = 0;
        double least = nx * other.x[0] + ny * other.y[0];
        for (int i = 1; i < other.count; i++) {
            double height = nx * other.x[i] + ny * other.y[i];
            if (height < least) {
                least = height;
                nearest = i;
            }
        }
        return nearest;
    }
}
