package rigibo.backend.flight;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.collision.Narrowphase;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.impact.Impact;
import rigibo.backend.impact.ImpactLaw;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.ImpactMode;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.PairTolerances;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.PointSpeeds;

/**
 * Flyers near a body of a pile that is struck or about to bounce. Only the pile's solver finds
 * where that body goes in the rest of the step, and by then the flyers would have passed it. So
 * flyers that it could reach join the pile. They lose no accuracy, since that solver moves bodies
 * that touch nothing as exactly as flight does.
 */
final class Bystanders {

    /**
     * Factor on the speed after a single impact for a body that may also be struck against others.
     */
    private static final double WEDGED = 2;

    /**
     * Largest allowance, in widths. A storey of a falling pyramid that is not looked for sinks into
     * the one below by as much, and what is above falls farther.
     */
    private static final double MOST_ALLOWED = 2e-3;

    /**
     * Allowance in widths where impacts are split within the step, and bodies sink in anyway. With
     * 0.02, as many more bodies join piles at {@code DRAFT} as let two piles of 300 gain energy.
     */
    private static final double ALLOWED_IF_SPLIT = 0.1;

    /** Deviation from its path, in widths, up to which a body's neighbours need not be searched. */
    private final double allowance;

    /** Reach of body A after the last measured impact, m; 0 within the allowance. */
    double reachOfA;

    /** Reach of body B after the last measured impact, m; 0 within the allowance. */
    double reachOfB;

    private final Bodies bodies;
    private final Pairs pairs;
    private final Counters counters;
    private final Narrowphase narrowphase;
    private final Broadphase broadphase;
    private final Trajectories paths;
    private final ImpactLaw law = new ImpactLaw();
    private final Pose poseA = new Pose();
    private final Pose poseB = new Pose();

    /**
     * Where impacts are in time order, sets the allowance to twice the square root of the impact
     * tolerance, in widths, within its bound. For a body one metre wide the root is the geometric
     * mean of the tolerance and the width.
     */
    Bystanders(
            DataStorage data,
            Narrowphase narrowphase,
            Broadphase broadphase,
            Trajectories paths,
            Accuracy accuracy) {
        allowance =
                accuracy.impacts() == ImpactMode.EVENTS
                        ? Math.min(MOST_ALLOWED, 2 * Math.sqrt(accuracy.impactTolerance()))
                        : ALLOWED_IF_SPLIT;
        bodies = data.bodies;
        pairs = data.pairs;
        counters = data.counters;
        this.narrowphase = narrowphase;
        this.broadphase = broadphase;
        this.paths = paths;
    }

    /**
     * Computes the reach of both bodies when a flyer strikes a body of a pile: {@link #reachOfA}
     * and {@link #reachOfB}. The impact is resolved in the frame of the pile's body, so that speeds
     * do not depend on what carries the pile.
     *
     * @param isPileA whether body A is the pile's
     * @param left rest of the step, s
     */
    void measureImpact(int a, int b, Impact impact, boolean isPileA, double left) {
        double u = isPileA ? impact.velocityAX : impact.velocityBX;
        double v = isPileA ? impact.velocityAY : impact.velocityBY;
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

    /** Deviation from its path, in widths, up to which a body's neighbours need not be searched. */
    double allowance() {
        return allowance;
    }

    /** Reach of a body whose velocity changes, m; other contacts may stop it or throw it back. */
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

    /** A distance in m by which a body may leave its path; 0 within its allowance. */
    double unlessAllowed(int slot, double way) {
        return leavesPath(slot, way) ? way : 0;
    }

    /** Whether a distance in m is more than the body's allowance. */
    private boolean leavesPath(int slot, double way) {
        return way > allowance * bodies.smallestWidth[slot];
    }

    /**
     * Reach of the bodies of a contact in a pile that strike each other, in a time of dt seconds,
     * m; 0 within the allowance.
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
     * Velocity of a body at a contact along x, m/s. For driven bodies it is that of the point of
     * contact: a long turning wall is slower there than at its far end.
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

    /** Greatest speed of a body's outline by its spin, m/s; of a driven body within a width, m. */
    private double turning(int slot, double width) {
        double reach = bodies.isDynamic(slot) ? bodies.sweepRadius[slot] : width;
        return Math.abs(bodies.spin[slot]) * reach;
    }

    /** Makes pairs of a body with everything within a reach (m) of it at a time (s). */
    void lookRound(int slot, double time, double reach) {
        counters.searches++;
        paths.poseAt(slot, time, poseA);
        broadphase.lookRound(slot, poseA.x, poseA.y, poseA.cos, poseA.sin, reach);
    }

    /**
     * Makes pairs of a body with everything within a reach (m) of where it is at the start and
     * where it is expected at the end of a step of dt seconds.
     */
    void lookAlong(int slot, double dt, double reach) {
        double speed = length(bodies.velocityX[slot], bodies.velocityY[slot]);
        double way = (speed + (bodies.turns() ? turning(slot, 0) : 0)) * dt;
        if (way <= reach) {
            lookRound(slot, 0, reach + way);
        } else {
            lookRound(slot, 0, reach);
            lookRound(slot, dt, reach);
        }
    }

    /**
     * Measures a pair one of whose bodies, in a pile, has a reach of {@code reach} m for the rest
     * ({@code left} s) of the step; returns whether the other body is within it. Two bodies that
     * were in piles from the start of the step are measured at their poses there, others at {@code
     * time}.
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

    /** Whether the gap between the bounding circles of two bodies is larger than {@code gap}, m. */
    private boolean isBeyond(int a, int b, double gap) {
        double dx = poseB.x - poseA.x;
        double dy = poseB.y - poseA.y;
        double apart = bodies.boundingRadius[a] + bodies.boundingRadius[b] + gap;
        return dx * dx + dy * dy > apart * apart;
    }

    /**
     * Reach (m) that a body gets when another one with a reach of {@code reach} may strike it; 0
     * within the allowance. The part of the gap that the two do not close by their own motion in dt
     * seconds is subtracted; of the rest the struck body gets a share by its mass. A flyer gets at
     * least the whole rest: it may fall on a body that a floor has stopped, and then the floor
     * stops it too.
     */
    double reachLeft(int pair, int struck, double reach, double dt) {
        double left = reach - Math.max(0, pairs.gap(pair) - narrowphase.reach(pair, dt));
        double share = shareOf(struck, pair);
        double handedOn = left * (paths.isFlyer(struck) ? Math.max(1, share) : share);
        return unlessAllowed(struck, handedOn);
    }

    /** Speed that the struck body of a pair gains, as a share of the speed of the other. */
    private double shareOf(int struck, int pair) {
        double inverse = bodies.inverseMass[struck];
        double both = inverse + bodies.inverseMass[pairs.other(pair, struck)];
        return inverse > 0 ? (1 + pairs.elasticityOf(pair)) * inverse / both : 0;
    }

    private boolean isFromStart(int slot) {
        return !paths.isFlyer(slot) && !(bodies.isDynamic(slot) && bodies.pileTimeOf(slot) > 0);
    }
}
