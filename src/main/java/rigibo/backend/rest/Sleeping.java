package rigibo.backend.rest;

import rigibo.backend.effect.Sleep;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.Pairs;
import rigibo.backend.storage.Roster;

/**
 * Puts islands to sleep by displacement: every body has stayed close to where it was for long
 * enough. Displacement instead of speed, so that a slowly sliding body stays awake however slow,
 * and one that trembles in place may sleep. What is slow and drifts on, for nothing resists it,
 * stays awake as well.
 */
public final class Sleeping {

    /**
     * By how much of the way the last velocity may differ from the mean one where a body goes on
     * evenly: what nothing resists does to round-off, what creeps or trembles does not.
     */
    private static final double EVEN = 1e-6;

    /**
     * Share of the distance below which a drift in the time of falling asleep does not count: it
     * would take a thousand such times to be told from rest.
     */
    private static final double UNTOLD = 1e-3;

    private final DataStorage data;
    private final Bodies bodies;
    private final Pairs pairs;
    private final Roster roster;
    private final Islands islands;
    private final Sleep sleep;

    /** Sleep by declared thresholds. */
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

    /** How long in s the most restless body of the island has stayed in place. */
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

    /** How long in s a body has stayed in place whose outline has turned so far in m, at most. */
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

    /** Whether a body that has stayed in place for a time in s did so only because it is slow. */
    private boolean driftsOn(int slot, double time) {
        double x = time * bodies.velocityX[slot];
        double y = time * bodies.velocityY[slot];
        double turn = time * bodies.spinOf(slot) * bodies.boundingRadius[slot];
        double squared = x * x + y * y + turn * turn;
        double untold = UNTOLD * sleep.distance() * bodies.smallestWidth[slot];
        return squared > untold * untold && (isEven(slot, x, y, turn, squared) || isLoose(slot));
    }

    /**
     * Whether a body has gone and turned, along the way in m on which its last velocities would
     * have taken it, as far as they would: across, it may have settled.
     */
    private boolean isEven(int slot, double x, double y, double turn, double squared) {
        double turned = bodies.turns() ? bodies.angle[slot] - bodies.stillAngle[slot] : 0;
        double along =
                x * (bodies.x[slot] - bodies.stillX[slot])
                        + y * (bodies.y[slot] - bodies.stillY[slot])
                        + turn * turned * bodies.boundingRadius[slot];
        return Math.abs(along - squared) <= EVEN * squared;
    }

    /** Whether nothing presses on a body or is joined to it that could hold it. */
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

    /** How far in m the body is from where it was. */
    private double moved(int slot) {
        double dx = bodies.x[slot] - bodies.stillX[slot];
        double dy = bodies.y[slot] - bodies.stillY[slot];
        return Math.sqrt(dx * dx + dy * dy);
    }

    /** How far in m any point of the body has turned since. */
    private double turned(int slot) {
        double angle = Math.abs(bodies.angle[slot] - bodies.stillAngle[slot]);
        return angle * bodies.boundingRadius[slot];
    }

    /** Whether something kinematic that moves touches the island: it will not stay still. */
    private boolean isDriven(int island) {
        for (int i = islands.pairStart[island]; i < islands.pairStart[island + 1]; i++) {
            int pair = islands.pairs[i];
            if (bodies.isDriven(pairs.bodyA[pair]) || bodies.isDriven(pairs.bodyB[pair])) {
                return true;
            }
        }
        return data.joints != null && isDrivenByJoint(data.joints, island);
    }

    /** Whether one of its joints is to something kinematic that moves. */
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
