package rigibo.backend.storage;

import rigibo.backend.setup.BodyDefinition;

/**
 * Puts bodies to rest, at their last good pose, when their state is no longer finite or far beyond
 * all physical bounds. Every stage that can produce such numbers checks for them before they reach
 * another body.
 */
public final class Quarantine {

    /** Speed beyond which doubles no longer resolve a collision, m/s and rad/s. */
    public static final double FASTEST = 10 * BodyDefinition.MOST_SPEED;

    private final DataStorage data;
    private final Bodies bodies;

    /** A quarantine for the bodies of a storage. */
    public Quarantine(DataStorage data) {
        this.data = data;
        bodies = data.bodies;
    }

    /** Whether a velocity in m/s, or an angular velocity in rad/s, is within bounds. */
    public static boolean isBounded(double speed) {
        return Math.abs(speed) < FASTEST;
    }

    /** Puts a dynamic body to rest where the step began if its motion is out of bounds. */
    public void putToRestIfUnbounded(int slot) {
        if (bodies.isDynamic(slot) && !isBounded(slot)) {
            putToRest(slot);
        }
    }

    private boolean isBounded(int slot) {
        return isBounded(bodies.velocityX[slot])
                && isBounded(bodies.velocityY[slot])
                && isBounded(bodies.spinOf(slot));
    }

    /** Puts a body to rest where the step began, and names it in the step's report. */
    public void putToRest(int slot) {
        bodies.x[slot] = bodies.startX[slot];
        bodies.y[slot] = bodies.startY[slot];
        bodies.halt(slot);
        bodies.clearAccelerations(slot);
        if (bodies.turns()) {
            bodies.angle[slot] = bodies.startAngle[slot];
            bodies.aim(slot);
            bodies.clearAngularAcceleration(slot);
        }
        // A driven body that was stopped must leave the roster of moving bodies.
        data.roster.isStale = true;
        data.counters.quarantine(slot);
    }
}
