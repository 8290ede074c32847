package rigibo.backend.rest;

import rigibo.backend.effect.Sleep;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Roster;

/**
 * Puts an island to sleep once every body of it has stayed close to one place for long enough.
 * Displacement is the criterion rather than speed, so that a sliding body stays awake however slow
 * it is, and a body that trembles in place can sleep. A slow body that drifts on without resistance
 * stays awake too.
 */
public final class Sleeping {

    /**
     * Largest deviation, as a share of the displacement, of a body that moves on uniformly: without
     * resistance the last velocity equals the mean one to round-off, while a creeping or trembling
     * body is farther off.
     */
    private static final double EVEN = 1e-6;

    /**
     * Share of the sleep distance below which a drift does not count: such a body would cover the
     * distance only in a thousand times the sleep time.
     */
    private static final double UNTOLD = 1e-3;

    private final DataStorage data;
    private final Bodies bodies;
    private final Pairs pairs;
    private final Roster roster;
    private final Islands islands;
    private final Sleep sleep;

    /** Sleep with the thresholds of the declared effect. */
    public Sleeping(DataStorage data, Sleep sleep) {
        this.data = data;
        bodies = data.bodies;
        pairs = data.pairs;
        roster = data.roster;
        islands = data.islands;
        this.sleep = sleep;
    }

    /** Measures every island's rest after a step of {@code dt} seconds. */
    public void settle(double dt) {
        for (int island = 0; island < islands.count; island++) {
            double stillest = stillTime(island, dt);
            if (stillest >= sleep.seconds() && !isDriven(island)) {
                putToSleep(island);
            }
        }
    }

    /** Time in s for which all bodies of an island have stayed in place. */
    private double stillTime(int island, double dt) {
        int start = islands.bodyStart[island];
        int end = islands.bodyStart[island + 1];
        double least = Double.POSITIVE_INFINITY;
        if (bodies.turns()) {
            for (int i = start; i < end; i++) {
                int slot = islands.bodies[i];
                least = Math.min(least, stillTime(slot, turned(slot), dt));
            }
        } else {
            for (int i = start; i < end; i++) {
                least = Math.min(least, stillTime(islands.bodies[i], 0, dt));
            }
        }
        return least;
    }

    /**
     * Time in s for which a body has stayed in place; its outline has turned by {@code turned}, m.
     */
    private double stillTime(int slot, double turned, double dt) {
        double limit = sleep.distance() * bodies.smallestWidth[slot];
        double time = bodies.stillTime[slot] + dt;
        if (moved(slot) + turned > limit || time >= sleep.seconds() && driftsOn(slot, time)) {
            bodies.restartStillness(slot);
        } else {
            bodies.stillTime[slot] = time;
        }
        return bodies.stillTime[slot];
    }

    /** Whether a body that stayed in place for a time in s did so only because it drifts slowly. */
    private boolean driftsOn(int slot, double time) {
        double x = time * bodies.velocityX[slot];
        double y = time * bodies.velocityY[slot];
        double turn = time * bodies.spinOf(slot) * bodies.boundingRadius[slot];
        double squared = x * x + y * y + turn * turn;
        double untold = UNTOLD * sleep.distance() * bodies.smallestWidth[slot];
        return squared > untold * untold && (isEven(slot, x, y, turn, squared) || isLoose(slot));
    }

    /**
     * Whether a body moved and turned as far as its last velocities would have taken it, measured
     * along that displacement (m); motion across it may be settling.
     */
    private boolean isEven(int slot, double x, double y, double turn, double squared) {
        double turned = bodies.turns() ? bodies.angle[slot] - bodies.stillAngle[slot] : 0;
        double along =
                x * (bodies.x[slot] - bodies.stillX[slot])
                        + y * (bodies.y[slot] - bodies.stillY[slot])
                        + turn * turned * bodies.boundingRadius[slot];
        return Math.abs(along - squared) <= EVEN * squared;
    }

    /** Whether no loaded contact and no joint could hold a body. */
    private boolean isLoose(int slot) {
        for (int p = bodies.firstPair[slot]; p != Pairs.NONE; p = pairs.nextOf(p, slot)) {
            for (int point = 2 * p; point < 2 * p + pairs.points[p]; point++) {
                if (pairs.normalForce[point] > 0) {
                    return false;
                }
            }
        }
        return data.joints == null || data.joints.firstOf(slot) == JointStore.NONE;
    }

    /** Distance of the body from its reference place, m. */
    private double moved(int slot) {
        double dx = bodies.x[slot] - bodies.stillX[slot];
        double dy = bodies.y[slot] - bodies.stillY[slot];
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** Largest displacement of a point of the body by turning since its reference pose, m. */
    private double turned(int slot) {
        double angle = Math.abs(bodies.angle[slot] - bodies.stillAngle[slot]);
        return angle * bodies.boundingRadius[slot];
    }

    /** Whether a moving kinematic body touches the island, which then will not stay still. */
    private boolean isDriven(int island) {
        for (int i = islands.pairStart[island]; i < islands.pairStart[island + 1]; i++) {
            int pair = islands.pairs[i];
            if (bodies.isDriven(pairs.bodyA[pair]) || bodies.isDriven(pairs.bodyB[pair])) {
                return true;
            }
        }
        return data.joints != null && isDrivenByJoint(data.joints, island);
    }

    /** Whether one of the island's joints is to a moving kinematic body. */
    private boolean isDrivenByJoint(JointStore joints, int island) {
        int end = islands.areJoined(island) ? islands.jointStart[island + 1] : 0;
        for (int i = end == 0 ? 0 : islands.jointStart[island]; i < end; i++) {
            int joint = islands.joints[i];
            if (bodies.isDriven(joints.bodyA[joint]) || bodies.isDriven(joints.bodyB[joint])) {
                return true;
            }
        }
        return false;
    }

    private void putToSleep(int island) {
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            int slot = islands.bodies[i];
            bodies.awake[slot] = false;
            bodies.halt(slot);
        }
        roster.isStale = true;
    }
}
