package rigibo.backend.flight;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.impact.Impact;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;

/**
 * Adds to the expected impact of one pair of parts the outermost points of all parts of the two
 * bodies that meet along the same line. Without them, a box of three strips that lands flat would
 * be expected to turn about the strip that is found first.
 */
final class ImpactOfParts {

    /** Cosine of the largest angle between the normals of points on one line. */
    private static final double PARALLEL = 1 - 1e-6;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Narrowphase narrowphase;

    private double low;
    private double high;
    private int lowest;
    private int highest;

    ImpactOfParts(Bodies bodies, Pairs pairs, Narrowphase narrowphase) {
        this.bodies = bodies;
        this.pairs = pairs;
        this.narrowphase = narrowphase;
    }

    /** Widens the impact of a pair that was measured at these poses; the gap of its points is m. */
    void widen(Impact impact, int pair, Pose poseA, Pose poseB, double nearest) {
        if (!bodies.mayHaveParts()) {
            return;
        }
        low = Double.POSITIVE_INFINITY;
        high = Double.NEGATIVE_INFINITY;
        take(pair, pair, nearest);
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        int body = bodies.isDynamic(a) ? a : b;
        double touching = PairTolerances.TOUCHING_GAP * PairTolerances.width(bodies, a, b);
        for (int p = bodies.firstPair[body]; p != Pairs.NONE; p = pairs.nextOf(p, body)) {
            if (p != pair && pairs.other(p, body) == (body == a ? b : a)) {
                narrowphase.measure(p, poseA, poseB, touching);
                take(pair, p, nearest);
            }
        }
        impact.points = 0;
        add(impact, lowest, poseA, poseB);
        if (lowest != highest) {
            add(impact, highest, poseA, poseB);
        }
    }

    /** Considers the points of another pair if they lie on one line with those of a pair. */
    private void take(int pair, int other, double nearest) {
        double nx = pairs.normalX[pair];
        double ny = pairs.normalY[pair];
        if (nx * pairs.normalX[other] + ny * pairs.normalY[other] < PARALLEL) {
            return;
        }
        for (int q = 2 * other; q < 2 * other + pairs.points[other]; q++) {
            double along = nx * pairs.pointY[q] - ny * pairs.pointX[q];
            if (pairs.separation[q] <= nearest && along < low) {
                low = along;
                lowest = q;
            }
            if (pairs.separation[q] <= nearest && along > high) {
                high = along;
                highest = q;
            }
        }
    }

    private void add(Impact impact, int point, Pose poseA, Pose poseB) {
        impact.addPoint(
                pairs.pointX[point], pairs.pointY[point], poseA.x, poseA.y, poseB.x, poseB.y);
    }
}
