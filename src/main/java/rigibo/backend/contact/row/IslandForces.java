package rigibo.backend.contact.row;

import rigibo.backend.force.ChangingForces;
import rigibo.backend.force.Instant;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Quarantine;

/**
 * Forces that vary along the path, on bodies in piles: evaluated before every kick at the present
 * places and velocities. For forces that depend on the place, the leapfrog is of second order.
 */
public final class IslandForces {

    private final DataStorage data;
    private final Bodies bodies;
    private final ChangingForces forces;
    private final Instant instant = new Instant();
    private double change;

    /** The given forces on the bodies of a storage. */
    public IslandForces(DataStorage data, ChangingForces forces) {
        this.data = data;
        this.forces = forces;
        bodies = data.bodies;
    }

    /**
     * Replaces the forces in the packed bodies' accelerations with the present ones, for a kick of
     * {@code length} s around a time, s after the step's start; {@code turns} is null without
     * rotation.
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
     * Greatest change of a body's pull in the last refresh, m/s², with angular ones times its
     * radius.
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
        // Non-finite forces are not taken over; the next step refuses them at its start.
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
     * Share of a force that is applied: 1, or less for a force that would reverse the motion it
     * acts against within the kick, so that no drag, however strong, throws a body back.
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

    /** Ratio of a force's change to the force that it opposes. */
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
