package rigibo.backend.rest;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.PointSpeeds;
import rigibo.backend.storage.Waking;

/**
 * Separates bodies in flight from bodies in piles. A body is piled when one of its pairs rests: the
 * two touch, an acceleration presses them together, and they part too slowly for it to be seen. A
 * pair that did not rest before starts to rest only when it lies still; a bouncing pair comes to
 * rest in flight, by the end of its series of bounces.
 */
public final class PileClassifier {

    /**
     * Relative speed divided by the pressing acceleration, s, below which a pair that touches for
     * the first time counts as lying still; only round-off is below it.
     */
    private static final double STILLNESS = 1e-6;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Waking waking;
    private final double touchTolerance;
    private final ImpactMode mode;

    /** A classifier for an accuracy. */
    public PileClassifier(DataStorage data, Accuracy accuracy, ImpactMode mode) {
        bodies = data.bodies;
        pairs = data.pairs;
        waking = new Waking(data);
        touchTolerance = accuracy.impactTolerance();
        this.mode = mode;
    }

    /** Marks the piled bodies; before, all bodies count as flyers. */
    public void classify(double dt) {
        // Both lists grow while they are read, since woken bodies add their pairs.
        for (int i = 0; i < pairs.activeCount; i++) {
            classifyPair(pairs.active[i]);
        }
        for (int i = 0; i < pairs.activeCount; i++) {
            waking.wakeWhatIsHit(pairs.active[i], dt);
        }
    }

    private void classifyPair(int pair) {
        pairs.resting[pair] = rests(pair);
        if (pairs.resting[pair]) {
            pile(pairs.bodyA[pair]);
            pile(pairs.bodyB[pair]);
        }
    }

    /** Piles a body; a sleeper on which an awake body leans wakes, with all it touches. */
    private void pile(int slot) {
        if (!bodies.isDynamic(slot)) {
            return;
        }
        if (bodies.awake[slot]) {
            bodies.piled[slot] = true;
        } else {
            waking.wakeIntoPile(slot);
        }
    }

    private boolean rests(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double width = PairTolerances.width(bodies, a, b);
        double gap = pairs.gap(pair);
        if (mode != ImpactMode.EVENTS) {
            // Without a queue of impacts the solver of piles takes every pair that may touch in
            // this step.
            return pairs.points[pair] > 0
                    && (mode == ImpactMode.SPLIT || gap <= PairTolerances.TOUCHING_GAP * width);
        }
        if (!(gap <= PairTolerances.TOUCHING_GAP * width)) {
            return false;
        }
        if (gap < -PairTolerances.TOUCHING_GAP * width) {
            return true;
        }
        double pressing =
                PairTolerances.pressingAcceleration(
                        bodies, a, b, pairs.normalX[pair], pairs.normalY[pair]);
        if (pairs.resting[pair]) {
            double force = pairs.normalForce[2 * pair];
            boolean isPressed = pressing > 0 || PairTolerances.isPressing(bodies, a, b, force);
            return isPressed && parting(pair) <= PairTolerances.restSpeed(pressing, width);
        }
        return pressing > 0
                && gap <= touchTolerance * width
                && Math.abs(parting(pair)) <= STILLNESS * pressing;
    }

    /** Greatest parting speed of the pair's points, m/s; negative when all points close. */
    private double parting(int pair) {
        if (!bodies.turns()) {
            return partingOfCentres(pair);
        }
        double fastest = Double.NEGATIVE_INFINITY;
        for (int point = 2 * pair; point < 2 * pair + pairs.points[pair]; point++) {
            fastest = Math.max(fastest, PointSpeeds.parting(bodies, pairs, pair, point));
        }
        return fastest;
    }

    /** Parting speed without rotation, which is the same at all points, m/s. */
    private double partingOfCentres(int pair) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double vx = bodies.velocityX[b] - bodies.velocityX[a];
        double vy = bodies.velocityY[b] - bodies.velocityY[a];
        return vx * pairs.normalX[pair] + vy * pairs.normalY[pair];
    }
}
