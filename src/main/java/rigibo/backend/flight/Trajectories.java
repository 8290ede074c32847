package rigibo.backend.flight;

import rigibo.backend.collision.distance.Motion;
import rigibo.backend.collision.manifold.Pose;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Roster;

import java.util.Arrays;

/**
 * The motion of each body within the step. A body in flight follows its exact path from the time of
 * its columns on; the motion of a body in a pile is predicted from its velocity.
 */
final class Trajectories {

    private final Bodies bodies;
    private final Motion motion = new Motion();

    /** By flyer: the time that its columns hold, s after the step's start. */
    private double[] since = new double[16];

    /** By body: whether it joined a pile in this step. */
    private boolean[] hasLanded = new boolean[16];

    /** By body: predicted velocity after it joined a pile, x and y, m/s. */
    private double[] expected = new double[2 * 16];

    /** By flyer: whether it waits in place for the end of the step. */
    private boolean[] stands = new boolean[16];

    /** Turning on the paths; null without rotation. */
    private final TurningPaths turning;

    Trajectories(Bodies bodies) {
        this.bodies = bodies;
        turning = bodies.turns() ? new TurningPaths(bodies, this) : null;
    }

    /** Starts a step, at whose start all columns hold. */
    void begin() {
        if (since.length < bodies.type.length) {
            since = new double[bodies.type.length];
            hasLanded = new boolean[bodies.type.length];
            expected = new double[2 * bodies.type.length];
            stands = new boolean[bodies.type.length];
        }
        if (turning != null) {
            turning.reserve();
        }
        Arrays.fill(since, 0, bodies.slots.high, 0);
        Arrays.fill(hasLanded, 0, bodies.slots.high, false);
        Arrays.fill(stands, 0, bodies.slots.high, false);
    }

    boolean isFlyer(int slot) {
        return bodies.isDynamic(slot) && bodies.awake[slot] && !bodies.piled[slot];
    }

    /** Ends a flyer's flight for this step: from a time in s on, it is part of a pile. */
    void land(int slot, double time) {
        if (isFlyer(slot)) {
            bodies.piled[slot] = true;
            bodies.pileTime[slot] = time;
            expect(slot, bodies.velocityX[slot], bodies.velocityY[slot], bodies.spinOf(slot));
        }
    }

    /** Lets a flyer wait at the place in its columns until the step ends; it keeps its velocity. */
    void stand(int slot) {
        stands[slot] = isFlyer(slot);
    }

    /** Whether a flyer waits for the end of the step. */
    boolean stands(int slot) {
        return stands[slot] && isFlyer(slot);
    }

    /** Lets a body that was to land later land at a time (s) already, since something hits it. */
    void landEarlier(int slot, double time) {
        double left = bodies.pileTime[slot] - time;
        if (hasLanded[slot] && left > 0) {
            bodies.x[slot] -= left * bodies.velocityX[slot];
            bodies.y[slot] -= left * bodies.velocityY[slot];
            bodies.turn(slot, -left * bodies.spinOf(slot));
            bodies.pileTime[slot] = time;
        }
    }

    /** Sets the predicted velocity of a body that has landed, for flyers that may meet it. */
    void expect(int slot, double velocityX, double velocityY, double spin) {
        hasLanded[slot] = true;
        expected[2 * slot] = velocityX;
        expected[2 * slot + 1] = velocityY;
        if (turning != null) {
            turning.expect(slot, spin);
        }
    }

    /** Whether a body joined a pile in this step. */
    boolean hasLanded(int slot) {
        return hasLanded[slot];
    }

    /** The time that a flyer's columns hold, s after the step's start. */
    double since(int slot) {
        return since[slot];
    }

    /** Writes a body's path within the step. */
    void load(int slot, Motion out) {
        loadWay(slot, out);
        if (turning != null) {
            turning.load(slot, out);
        }
    }

    /** Writes the path of a body's centre of mass within the step. */
    private void loadWay(int slot, Motion out) {
        out.take(bodies, slot);
        if (stands(slot)) {
            out.startTime = since[slot];
            stopWay(out);
        } else if (isFlyer(slot)) {
            out.startTime = since[slot];
            out.drag = bodies.drag == null ? 0 : bodies.drag[slot];
        } else {
            loadUnflying(slot, out);
        }
    }

    private static void stopWay(Motion out) {
        out.velocityX = 0;
        out.velocityY = 0;
        out.accelerationX = 0;
        out.accelerationY = 0;
    }

    /** Writes the straight path of a body not in flight at its predicted velocity, or at rest. */
    private void loadUnflying(int slot, Motion out) {
        out.startTime = bodies.isDynamic(slot) ? bodies.pileTimeOf(slot) : since[slot];
        out.accelerationX = 0;
        out.accelerationY = 0;
        if (hasLanded[slot]) {
            out.velocityX = expected[2 * slot];
            out.velocityY = expected[2 * slot + 1];
        } else if (!bodies.isMoved(slot)) {
            out.velocityX = 0;
            out.velocityY = 0;
        }
    }

    /** Writes the pose of a body on its path at a time, s after the step's start. */
    void poseAt(int slot, double time, Pose out) {
        load(slot, motion);
        motion.poseAt(time, out);
    }

    /** Advances a flyer's columns to a time, s after the step's start. */
    void advance(int slot, double time) {
        if (stands(slot)) {
            return;
        }
        if (turning != null) {
            turning.advance(slot, time);
        }
        move(slot, time);
    }

    /** Advances the columns of all flyers to a time, s after the step's start. */
    void advanceAll(Roster roster, double time) {
        if (turning != null) {
            turning.advanceAll(roster, time);
        }
        for (int i = 0; i < roster.awakeCount; i++) {
            if (isFlyer(roster.awake[i]) && !stands(roster.awake[i])) {
                move(roster.awake[i], time);
            }
        }
    }

    private void move(int slot, double time) {
        if (time == since[slot]) {
            return;
        }
        loadWay(slot, motion);
        motion.advance(time);
        bodies.x[slot] = motion.x;
        bodies.y[slot] = motion.y;
        bodies.velocityX[slot] = motion.velocityX;
        bodies.velocityY[slot] = motion.velocityY;
        since[slot] = time;
    }
}
