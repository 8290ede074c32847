package rigibo.backend.contact.row;

import rigibo.backend.storage.Bodies;

/** How the bodies of a packed island turn, from the columns and back: rotation is declared. */
public final class PackedTurns {

    private final Bodies bodies;
    private final Motions motions;

    public PackedTurns(Bodies bodies, Motions motions) {
        this.bodies = bodies;
        this.motions = motions;
    }

    /** Completes the entries from one on, which were packed as if they did not turn. */
    void pack(int first) {
        double[] m = motions.data;
        for (int entry = first; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            int at = entry * Motions.STRIDE;
            m[at + Motions.SPIN] = bodies.spin[slot];
            m[at + Motions.INVERSE_INERTIA] = bodies.inverseInertia[slot];
        }
    }

    /** Adds the angular accelerations to the spins, from one time in s to a later one: a kick. */
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

    /** Puts what forces that change along the way do now in place of what they did, rad/s². */
    void replacePull(int slot, double turn) {
        bodies.angularAcceleration[slot] += turn - bodies.pullTurn[slot];
        bodies.pullTurn[slot] = turn;
    }

    /** Carries what the island came to back into the columns. */
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
