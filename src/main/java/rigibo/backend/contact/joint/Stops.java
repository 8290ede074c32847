package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.PairTolerances;

/**
 * What is known of the stops among the rows: of limits, ropes and points of contact. Lengths are m,
 * or rad for the angle of a hinge.
 */
final class Stops {

    /** Approach that is round-off, as a share of the fastest motion of the island. */
    private static final double ROUND_OFF = 1e-9;

    /** What a body gains by the effects in a substep that passes for a load, as in heaps. */
    private static final double PULLED = 0.25;

    private final Bodies bodies;
    private final JointStore joints;
    private final Motions motions;
    private final PackedContacts contacts;
    private final NeutralRows rows;
    private final JointRows jointRows;
    private final PackedJoints packed;
    private final double tolerance;

    /** Of the packed island: a substep, s, and the strongest acceleration of the effects, m/s². */
    private double h;

    private double strongest;

    /** How long the last kick was, s. */
    private double kicked;

    /** Approach that is round-off at present, m/s. */
    private double noise;

    Stops(
            DataStorage data,
            Motions motions,
            PackedContacts contacts,
            NeutralRows rows,
            JointRows jointRows,
            PackedJoints packed,
            double tolerance) {
        bodies = data.bodies;
        joints = data.jointsOrNone();
        this.motions = motions;
        this.contacts = contacts;
        this.rows = rows;
        this.jointRows = jointRows;
        this.packed = packed;
        this.tolerance = tolerance;
    }

    /** Begins a packed island with substeps of so many seconds. */
    void begin(double substep) {
        h = substep;
        strongest = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            int slot = motions.slots[entry];
            double x = bodies.accelerationX[slot];
            double y = bodies.accelerationY[slot];
            strongest = Math.max(strongest, Math.sqrt(x * x + y * y));
        }
    }

    /** Begins to ask about rows that were just written, after a kick of so many seconds. */
    void ask(double lastKick) {
        kicked = lastKick;
        double fastest = motions.fastest();
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            double reach = motions.reach[at / Motions.STRIDE];
            if (reach < Double.POSITIVE_INFINITY) {
                fastest = Math.max(fastest, Math.abs(motions.data[at + Motions.SPIN]) * reach);
            }
        }
        noise = ROUND_OFF * fastest;
    }

    /** Whether a row only pushes. */
    boolean isStop(int row) {
        int part = rows.part[row];
        if (rows.joint[row] != NeutralRows.NONE) {
            boolean isEnd = part == JointRows.LOWER || part == JointRows.UPPER;
            return isEnd && !rows.isEquation(row);
        }
        return part == PackedContacts.IMPULSE0 || part == PackedContacts.IMPULSE1;
    }

    /** How far from its stop a row may be and be on it. */
    double tolerance(int row) {
        if (rows.joint[row] == NeutralRows.NONE) {
            return tolerance * width(row);
        }
        return tolerance * jointRows.size(row);
    }

    private double width(int row) {
        int at = rows.contact[row] * PackedContacts.STRIDE;
        return contacts.data[at + PackedContacts.WIDTH];
    }

    /** What a row carried in the last kick, N·s or N·m·s. */
    double load(int row) {
        return rows.joint[row] == NeutralRows.NONE
                ? contacts.data[rows.contact[row] * PackedContacts.STRIDE + rows.part[row]]
                : packed.impulseOf(rows.joint[row], rows.part[row]);
    }

    /** Whether a row carries so much that it takes part in impacts of others at once. */
    boolean isLoaded(int row) {
        double pressing = pressing(row);
        return pressing > 0
                && (rows.joint[row] != NeutralRows.NONE || pressing >= PULLED * strongest);
    }

    /** The acceleration with which a row was pressed on its stop, m/s² or rad/s². */
    private double pressing(int row) {
        return kicked > 0 ? Math.max(0, load(row)) * rows.response[row] / kicked : 0;
    }

    /**
     * The approach from which on a row strikes its stop: one whose rebound would be seen, and more
     * than what it is pressed by within a substep; m/s or rad/s.
     */
    double leastApproach(int row) {
        double lift = PairTolerances.INVISIBLE_LIFT;
        double pulled = strongest;
        int joint = rows.joint[row];
        if (joint == NeutralRows.NONE) {
            lift *= width(row);
        } else {
            int slot = packed.slot[joint];
            if (joints.kind[slot] == JointKind.REVOLUTE.ordinal()) {
                jointRows.place(row);
                pulled /= jointRows.size();
            } else {
                int a = joints.bodyA[slot];
                lift *= PairTolerances.width(bodies, a, joints.bodyB[slot]);
            }
        }
        double pressed = Math.max(pulled, pressing(row));
        double unseen = Math.sqrt(2 * pressed * lift);
        return Math.max(noise / rows.unit[row], Math.max(unseen, pressed * h));
    }

    /** The share of its approach with which a row rebounds. */
    double elasticity(int row) {
        if (rows.joint[row] != NeutralRows.NONE) {
            return rows.elasticity[row];
        }
        int at = rows.contact[row] * PackedContacts.STRIDE;
        return contacts.data[at + PackedContacts.ELASTICITY];
    }
}
