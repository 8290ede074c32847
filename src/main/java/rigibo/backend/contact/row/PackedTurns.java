package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;

/** Copies the turning of a packed island's bodies from the columns and back, with rotation only. */
public final class PackedTurns {

    private final Bodies bodies;
    private final Motions motions;

    public PackedTurns(Bodies bodies, Motions motions) {
        this.bodies = bodies;
        this.motions = motions;
    }

    /** Adds the turning to the entries from one on, which were packed without it. */
    void pack(int first) {
        double[] m = motions.data;
        for (int entry = first; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            m[at + Motions.SPIN] = bodies.spin[slot];
            m[at + Motions.INVERSE_INERTIA] = bodies.inverseInertia[slot];
        }
    }

    /** Makes a kick of the spins from one time (s) to a later one. */
    void accelerate(double from, double to) {
        double[] m = motions.data;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            double length = to - Math.max(from, bodies.pileTime[slot]);
            if (m[at + Motions.INVERSE_MASS] > 0 && length > 0) {
                m[at + Motions.SPIN] += length * bodies.angularAcceleration[slot];
            }
        }
    }

    /** Replaces the angular acceleration by forces that vary along the path, rad/s². */
    void replacePull(int slot, double turn) {
        bodies.angularAcceleration[slot] += turn - bodies.pullTurn[slot];
        bodies.pullTurn[slot] = turn;
    }

    /** Writes the result of the island back into the columns. */
    void store() {
        double[] m = motions.data;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            if (bodies.isDynamic(slot)) {
                bodies.spin[slot] = m[at + Motions.SPIN];
                if (m[at + Motions.TURN] != 0) {
                    bodies.turn(slot, m[at + Motions.TURN]);
                }
            }
        }
    }
}
