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
     * from the other polygon, which sits at a place in this one's frame. The nearest corner walks
     * around the other polygon as the face walks around this one, so that n faces and m corners
     * cost n + m evaluations (rotating calipers).
     */
    boolean isApart(Polygon polygon, Polygon other, Pose place, double reach) {
        int last = other.corners() - 1;
        int nearest = 0;
        separation = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < polygon.corners(); i++) {
            double nx = polygon.normalX(i);
            double ny = polygon.normalY(i);
            double mx = place.cos * nx + place.sin * ny;
            double my = place.cos * ny - place.sin * nx;
            if (i == 0) {
                nearest = nearestTo(other, mx, my);
            }
            double least = mx * other.cornerX(nearest) + my * other.cornerY(nearest);
            int next = nearest == last ? 0 : nearest + 1;
            double following = mx * other.cornerX(next) + my * other.cornerY(next);
            while (following < least) {
                least = following;
                nearest = next;
                next = nearest == last ? 0 : nearest + 1;
                following = mx * other.cornerX(next) + my * other.cornerY(next);
            }
            double front =
                    nx * (place.x - polygon.cornerX(i)) + ny * (place.y - polygon.cornerY(i));
            double gap = front + least;
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

    private static int nearestTo(Polygon other, double mx, double my) {
        int nearest = 0;
        double least = mx * other.cornerX(0) + my * other.cornerY(0);
        for (int i = 1; i < other.corners(); i++) {
            double height = mx * other.cornerX(i) + my * other.cornerY(i);
            if (height < least) {
                least = height;
                nearest = i;
            }
        }
        return nearest;
    }
}
