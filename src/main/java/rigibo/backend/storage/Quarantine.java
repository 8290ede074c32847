package rigibo.backend.storage;

import rigibo.backend.setup.BodyDefinition;

/**
 * Puts bodies to rest whose numbers are beyond all bounds, at their last good pose. Every stage
 * that can make such numbers asks before another body is told of them.
 */
public final class Quarantine {

    /** A body faster than this is beyond what doubles can collide, m/s, and rad/s. */
    public static final double FASTEST = 10 * BodyDefinition.MOST_SPEED;

    private final DataStorage data;
    private final Bodies bodies;

    /** Of the bodies of a storage. */
    public Quarantine(DataStorage data) {
        this.data = data;
        bodies = data.bodies;
    }

    /** Whether a velocity in m/s, or a spin in rad/s, is one that bodies can have. */
    public static boolean isBounded(double speed) {
        return Math.abs(speed) < FASTEST;
    }

    /** Puts a dynamic body to rest where the step began if its motion is beyond all bounds. */
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
        // A driven body stands still now and is no longer of those that move.
        data.roster.isStale = true;
        data.counters.quarantine(slot);
    }
}
