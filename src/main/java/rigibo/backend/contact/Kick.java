package rigibo.backend.contact;

import rigibo.backend.storage.Bodies;

/** Adds accelerations to the velocities of an island's bodies. */
final class Kick {

    private final Bodies bodies;
    private final Motions motions;

    /** Forces that change along the way, or null where there are none. */
    private final PileForces forces;

    Kick(Bodies bodies, Motions motions, PileForces forces) {
        this.bodies = bodies;
        this.motions = motions;
        this.forces = forces;
    }

    /**
     * Moves the velocities from one time to a later one, both in s after the step's start. A body
     * that joined the pile in between is kicked only from when it joined.
     */
    void accelerate(double from, double to) {
        if (forces != null) {
            forces.refresh(motions, (from + to) / 2, to - from);
        }
        double[] m = motions.data;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            double since = Math.max(from, bodies.pileTime[slot]);
            if (m[at + Motions.INVERSE_MASS] > 0 && to > since) {
                accelerate(m, at, slot, to - since);
            }
        }
    }

    private void accelerate(double[] m, int at, int slot, double length) {
        if (bodies.drag != null && bodies.drag[slot] > 0) {
            // v' = a − k·v, exactly: v·e^(−kh) + a·(1 − e^(−kh))/k.
            double k = bodies.drag[slot];
            double lost = -StrictMath.expm1(-k * length);
            m[at + Motions.VX] += lost * (bodies.accelerationX[slot] / k - m[at + Motions.VX]);
            m[at + Motions.VY] += lost * (bodies.accelerationY[slot] / k - m[at + Motions.VY]);
        } else {
            m[at + Motions.VX] += length * bodies.accelerationX[slot];
            m[at + Motions.VY] += length * bodies.accelerationY[slot];
        }
        m[at + Motions.SPIN] += length * bodies.angularAcceleration[slot];
    }
}
