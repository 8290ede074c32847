package rigibo.backend.flight;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.collision.Narrowphase;
import rigibo.backend.collision.Pose;
import rigibo.backend.impact.Impact;
import rigibo.backend.impact.ImpactLaw;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.PointSpeeds;

/**
 * Flyers near a body of a pile that is struck or about to bounce. Where that body goes in the rest
 * of the step only the pile's solver will tell, and by then they would have passed it. So those
 * that it could reach join the pile, whose solver moves what touches nothing as exactly as flight
 * does.
 */
final class Bystanders {

    /**
     * How much faster than by a single impact a body may leave when it is struck against others.
     */
    private static final double WEDGED = 2;

    /** How far a body may leave its path, in widths, before its neighbours have to be looked at. */
    private final double allowance;

    /** What was found of the last impact, m. */
    double reachOfA;

    double reachOfB;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Narrowphase narrowphase;
    private final Broadphase broadphase;
    private final Trajectories paths;
    private final ImpactLaw law = new ImpactLaw();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    /**
     * Allows bodies to leave their paths by twice the square root of the impact tolerance, in
     * widths. The root is the geometric mean of the tolerance (m) and the width of a body of one
     * metre.
     */
    Bystanders(
            DataStorage data,
            Narrowphase narrowphase,
            Broadphase broadphase,
            Trajectories paths,
            double impactTolerance) {
        allowance = 2 * Math.sqrt(impactTolerance);
        bodies = data.bodies;
        pairs = data.pairs;
        this.narrowphase = narrowphase;
        this.broadphase = broadphase;
        this.paths = paths;
    }

    /**
     * Finds how far (m) the bodies of an impact may get in the rest of the step (s) from where they
     * are expected: {@link #reachOfA} and {@link #reachOfB}, 0 where that is within the allowance.
     * A flyer strikes a pile whose carriers move at (u, v) m/s; the impact is resolved in their
     * frame.
     */
    void measureImpact(int a, int b, Impact impact, double u, double v, double left) {
        impact.velocityAX -= u;
        impact.velocityAY -= v;
        impact.velocityBX -= u;
        impact.velocityBY -= v;
        double oldAX = impact.velocityAX;
        double oldAY = impact.velocityAY;
        double oldBX = impact.velocityBX;
        double oldBY = impact.velocityBY;
        if (impact.points > 0) {
            law.resolve(impact);
        }
        reachOfA = reach(a, impact.velocityAX, impact.velocityAY, oldAX, oldAY, left);
        reachOfB = reach(b, impact.velocityBX, impact.velocityBY, oldBX, oldBY, left);
    }

    /** It may be stopped, or thrown back, by whatever else touches it. */
    private double reach(int slot, double vx, double vy, double oldX, double oldY, double left) {
        if (!bodies.isDynamic(slot)) {
            return 0;
        }
        double fastest = Math.max(length(vx, vy), length(oldX, oldY));
        double way = (fastest + (bodies.turns() ? turning(slot, 0) : 0)) * left;
        return leavesPath(slot, way) ? WEDGED * way : 0;
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }

    /** Whether a way of so many m takes a body off its path by more than it is allowed. */
    private boolean leavesPath(int slot, double way) {
        return way > allowance * bodies.smallestWidth[slot];
    }

    /**
     * How far in m the bodies of a contact in a pile may get in a step of dt seconds in which they
     * strike each other; 0 where that is within the allowance.
     */
    double reachOfBouncers(int pair, double dt) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        double x = meetsX(b, pair) - meetsX(a, pair);
        double y = meetsY(b, pair) - meetsY(a, pair);
        double width = PairTolerances.width(bodies, a, b);
        double turning = bodies.turns() ? turning(a, width) + turning(b, width) : 0;
        double closing = turning - (x * pairs.normalX[pair] + y * pairs.normalY[pair]);
        double unseen = allowance * width;
        boolean isSeen = closing * dt > Math.max(unseen, pairs.gap(pair));
        return isSeen ? WEDGED * (length(x, y) + turning) * dt : 0;
    }

    /**
     * Speed of a body at a contact, m/s: there a long wall that turns is slower than at its far
     * end.
     */
    private double meetsX(int slot, int pair) {
        return bodies.isDynamic(slot)
                ? bodies.velocityX[slot]
                : PointSpeeds.velocityX(bodies, pairs, 2 * pair, slot);
    }

    private double meetsY(int slot, int pair) {
        return bodies.isDynamic(slot)
                ? bodies.velocityY[slot]
                : PointSpeeds.velocityY(bodies, pairs, 2 * pair, slot);
    }

    /** Speed in m/s that turning gives the outline of a body, all round or across a contact. */
    private double turning(int slot, double width) {
        double reach = bodies.isDynamic(slot) ? bodies.sweepRadius[slot] : width;
        return Math.abs(bodies.spin[slot]) * reach;
    }

    /** Finds all that lies within a reach of a body at a time, as pairs. */
    void lookRound(int slot, double time, double reach) {
        paths.poseAt(slot, time, poseA);
        broadphase.lookRound(slot, poseA.x, poseA.y, poseA.cos, poseA.sin, reach);
    }

    /**
     * Measures a pair of which one body, of a pile, may get {@code reach} m away in the rest of the
     * step (s); returns whether the other is within that reach. Two that were in piles from the
     * start are measured where they began, others where they are by then.
     */
    boolean isWithinReach(int pair, double reach, double time, double left) {
        int a = pairs.bodyA[pair];
        int b = pairs.bodyB[pair];
        if (isFromStart(a) && isFromStart(b)) {
            poseA.set(bodies.x[a], bodies.y[a], bodies.cos[a], bodies.sin[a]);
            poseB.set(bodies.x[b], bodies.y[b], bodies.cos[b], bodies.sin[b]);
        } else {
            paths.poseAt(a, time, poseA);
            paths.poseAt(b, time, poseB);
        }
        double both = reach + narrowphase.reach(pair, time + left);
        if (pairs.points[pair] == 0 && isBeyond(a, b, both)) {
            return false;
        }
        narrowphase.measureContact(pair, poseA, poseB, both);
        return pairs.points[pair] > 0;
    }

    /** Whether even the bounding circles of two bodies are farther apart than by a gap in m. */
    private boolean isBeyond(int a, int b, double gap) {
        double dx = poseB.x - poseA.x;
        double dy = poseB.y - poseA.y;
        double apart = bodies.boundingRadius[a] + bodies.boundingRadius[b] + gap;
        return dx * dx + dy * dy > apart * apart;
    }

    /**
     * How far (m) a body may get when another strikes it whose reach is {@code reach}. That reach
     * first closes the gap, as far as the two do not close it on their own ways in dt seconds; of
     * what is left the struck body gets its share by mass. 0 where that is within the allowance. A
     * flyer keeps its whole way: it may fall on what a floor has stopped, and then is stopped by
     * the floor.
     */
    double reachLeft(int pair, int struck, double reach, double dt) {
        double left = reach - Math.max(0, pairs.gap(pair) - narrowphase.reach(pair, dt));
        double share = shareOf(struck, pair);
        double handedOn = left * (paths.isFlyer(struck) ? Math.max(1, share) : share);
        return leavesPath(struck, handedOn) ? handedOn : 0;
    }

    /** Speed with which the struck body of a pair leaves, as a share of the speed of the other. */
    private double shareOf(int struck, int pair) {
        double inverse = bodies.inverseMass[struck];
        double both = inverse + bodies.inverseMass[pairs.other(pair, struck)];
        return inverse > 0 ? (1 + pairs.elasticityOf(pair)) * inverse / both : 0;
    }

    private boolean isFromStart(int slot) {
        return !paths.isFlyer(slot) && !(bodies.isDynamic(slot) && bodies.pileTimeOf(slot) > 0);
    }
}
