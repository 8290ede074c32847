package rigibo.backend.contact.row;

import rigibo.backend.force.ChangingForces;
import rigibo.backend.force.Instant;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Quarantine;

/**
 * Forces that change along the way, on bodies in piles: asked for anew before every kick, at the
 * places and velocities that the bodies have by then. The leapfrog of kicks and drifts is of second
 * order for forces by place.
 */
public final class IslandForces {

    private final DataStorage data;
    private final Bodies bodies;
    private final ChangingForces forces;
    private final Instant instant = new Instant();
    private double change;

    /** These forces on the bodies of a storage. */
    public IslandForces(DataStorage data, ChangingForces forces) {
        this.data = data;
        this.forces = forces;
        bodies = data.bodies;
    }

    /**
     * Puts the forces of now in place of those in the packed bodies' accelerations, for a kick
     * around a time in s after the step's start and {@code length} s long; {@code turns} is null
     * where nothing turns.
     */
    void refresh(Motions motions, PackedTurns turns, double time, double length) {
        change = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            if (motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS] > 0) {
                refresh(motions, turns, entry, time, length);
            }
        }
    }

    /**
     * The greatest change of a body's pull by the last refresh, m/s², and rad/s² times its radius.
     */
    double change() {
        return change;
    }

    private void refresh(
            Motions motions, PackedTurns turns, int entry, double time, double length) {
        int slot = motions.slots[entry];
        double[] m = motions.data;
        int at = entry * Motions.STRIDE;
        instant.take(bodies, slot);
        instant.time = data.time + time;
        instant.x = bodies.x[slot] + m[at + Motions.DX] + time * motions.frameX;
        instant.y = bodies.y[slot] + m[at + Motions.DY] + time * motions.frameY;
        instant.angle = bodies.angle[slot] + m[at + Motions.TURN];
        instant.velocityX = m[at + Motions.VX] + motions.frameX;
        instant.velocityY = m[at + Motions.VY] + motions.frameY;
        instant.spin = m[at + Motions.SPIN];
        forces.evaluate(instant);
        double ax = instant.accelerationX;
        double ay = instant.accelerationY;
        double turn = instant.angularAcceleration;
        double gained = length * (Math.abs(ax) + Math.abs(ay) + Math.abs(turn));
        // Beyond all bounds they are left as they were: the next step begins by refusing them.
        if (Quarantine.isBounded(gained)) {
            double share = shareThatBrakes(ax, ay, turn, length);
            replace(slot, share * ax, share * ay);
            if (turns != null) {
                double more = Math.abs(share * turn - bodies.pullTurn[slot]);
                change = Math.max(change, more * bodies.boundingRadius[slot]);
                turns.replacePull(slot, share * turn);
            }
        }
    }

    /**
     * A force that would more than undo the motion that it acts against, were it to act for the
     * whole kick, is cut to what just does: no drag, however strong, throws a body back.
     */
    private double shareThatBrakes(double ax, double ay, double turn, double length) {
        instant.velocityX += length * ax;
        instant.velocityY += length * ay;
        instant.spin += length * turn;
        forces.evaluate(instant);
        double linear = overshoot(ax, ay, instant.accelerationX - ax, instant.accelerationY - ay);
        double angular = overshoot(turn, 0, instant.angularAcceleration - turn, 0);
        return 1 / Math.max(1, Math.max(linear, angular));
    }

    /** How many times over a change of a force undoes the force. */
    private static double overshoot(double x, double y, double changeX, double changeY) {
        double squared = x * x + y * y;
        return squared > 0 ? -(x * changeX + y * changeY) / squared : 0;
    }

    private void replace(int slot, double ax, double ay) {
        double more = Math.abs(ax - bodies.pullX[slot]) + Math.abs(ay - bodies.pullY[slot]);
        change = Math.max(change, more);
        bodies.accelerationX[slot] += ax - bodies.pullX[slot];
        bodies.accelerationY[slot] += ay - bodies.pullY[slot];
        bodies.pullX[slot] = ax;
        bodies.pullY[slot] = ay;
    }
}
