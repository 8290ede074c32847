package rigibo.backend.collision;

import rigibo.backend.collision.manifold.Manifold;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/** Finds which old contact point of a pair a point of its new manifold continues. */
final class FormerPoints {

    /** Distance between two points up to which they count as the same place, per metre of body. */
    private static final double SAME_PLACE = 1e-2;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Manifold manifold;

    FormerPoints(DataStorage data, Manifold manifold) {
        bodies = data.bodies;
        pairs = data.pairs;
        this.manifold = manifold;
    }

    /**
     * The old point of a pair that point {@code i} of the manifold continues, or {@link
     * Pairs#NONE}; both bodies have moved since by a common displacement, m. If the old and the new
     * manifold have two points each, these continue each other in their order along the surface,
     * whatever their features. Otherwise two equal boxes on each other would lose their warm start
     * whenever round-off makes the other box's corner stand out.
     */
    int of(int pair, int i, double wayX, double wayY) {
        int first = 2 * pair;
        int old = pairs.points[pair];
        if (old == 2 && manifold.count == 2) {
            double ahead =
                    along(
                            manifold.pointX[i] - manifold.pointX[1 - i],
                            manifold.pointY[i] - manifold.pointY[1 - i]);
            double oldAhead =
                    along(
                            pairs.pointX[first] - pairs.pointX[first + 1],
                            pairs.pointY[first] - pairs.pointY[first + 1]);
            return ahead > 0 == oldAhead > 0 ? first : first + 1;
        }
        for (int point = first; point < first + old; point++) {
            if (pairs.feature[point] == manifold.feature[i]) {
                return point;
            }
        }
        return samePlace(pair, i, wayX, wayY);
    }

    /**
     * The old point at the place of a new one, relative to the bodies. A corner gets a new feature
     * id when a face comes to lie in front of it, or when a seam has turned its normal.
     */
    private int samePlace(int pair, int i, double wayX, double wayY) {
        double width = PairTolerances.width(bodies, pairs.bodyA[pair], pairs.bodyB[pair]);
        double least = SAME_PLACE * width;
        int nearest = Pairs.NONE;
        for (int point = 2 * pair; point < 2 * pair + pairs.points[pair]; point++) {
            double away = away(point, i, wayX, wayY);
            boolean isOthers = manifold.count == 2 && away(point, 1 - i, wayX, wayY) < away;
            if (away < least && !isOthers) {
                least = away;
                nearest = point;
            }
        }
        return nearest;
    }

    private double away(int point, int i, double wayX, double wayY) {
        double x = manifold.pointX[i] - pairs.pointX[point] - wayX;
        double y = manifold.pointY[i] - pairs.pointY[point] - wayY;
        return Math.sqrt(x * x + y * y);
    }

    private double along(double x, double y) {
        return y * manifold.normalX - x * manifold.normalY;
    }
}
