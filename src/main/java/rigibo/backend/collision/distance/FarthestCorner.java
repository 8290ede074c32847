package rigibo.backend.collision.distance;

import rigibo.backend.geometry.Outline;

/** The reach of a polygon along a sequence of directions, each close to the one before. */
final class FarthestCorner {

    /** The farthest corner in the last search; the next one starts from it. */
    private int corner;

    /** Reach in m from the centre of mass along a direction in the polygon's own frame. */
    double along(Outline polygon, double x, double y) {
        int last = polygon.corners() - 1;
        int at = Math.min(corner, last);
        double top = x * polygon.cornerX(at) + y * polygon.cornerY(at);
        int next = at == last ? 0 : at + 1;
        double height = x * polygon.cornerX(next) + y * polygon.cornerY(next);
        if (height > top) {
            // On a convex outline, climbing from corner to corner leads to the farthest one.
            while (height > top) {
                top = height;
                at = next;
                next = at == last ? 0 : at + 1;
                height = x * polygon.cornerX(next) + y * polygon.cornerY(next);
            }
        } else {
            next = at == 0 ? last : at - 1;
            height = x * polygon.cornerX(next) + y * polygon.cornerY(next);
            while (height > top) {
                top = height;
                at = next;
                next = at == 0 ? last : at - 1;
                height = x * polygon.cornerX(next) + y * polygon.cornerY(next);
            }
        }
        corner = at;
        return top;
    }
}
