package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointStore;
import rigibo.backend.storage.PairTolerances;

/**
 * The stops among the rows: limits, ropes and contact points. Lengths are in m, or rad for the
 * angle of a hinge.
 */
final class Stops {

    /** Approach speed that is round-off, as a share of the island's fastest motion. */
    private static final double APPROACH_ROUND_OFF = 1e-9;

    /**
     * Acceleration by its impulse from which on a contact counts as loaded, as a share of the
     * strongest acceleration by the effects.
     */
    private static final double PULLED = 0.25;

    private final Bodies bodies;
    private final JointStore joints;
    private final Motions motions;
    private final PackedContacts contacts;
    private final NeutralRows rows;
    private final JointPlaces jointPlaces;
    private final PackedJoints packed;
    private final double tolerance;

    /**
     * Of the packed island: the length of a substep, s, and the strongest acceleration by the
     * effects, m/s².
     */
    private double h;

    private double strongest;

    /** Length of the last kick, s. */
    private double kicked;

    /** Approach speed that is round-off at present, m/s. */
    private double noise;

    Stops(
            DataStorage data,
            Motions motions,
            PackedContacts contacts,
            NeutralRows rows,
            JointPlaces jointPlaces,
            PackedJoints packed,
            double tolerance) {
        bodies = data.bodies;
        joints = data.jointsOrNone();
        this.motions = motions;
        this.contacts = contacts;
        this.rows = rows;
        this.jointPlaces = jointPlaces;
        this.packed = packed;
        this.tolerance = tolerance;
    }

    /** Begins a packed island with substeps of a length in s. */
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

    /** Begins with rows that were just written, after a kick of a length in s. */
    void ask(double lastKick) {
        kicked = lastKick;
        double fastest = motions.fastest();
        for (int at = Motions.STRIDE; at < motions.count * Motions.STRIDE; at += Motions.STRIDE) {
            double reach = motions.reach[at / Motions.STRIDE];
            if (reach < Double.POSITIVE_INFINITY) {
                fastest = Math.max(fastest, Math.abs(motions.data[at + Motions.SPIN]) * reach);
            }
        }
        noise = APPROACH_ROUND_OFF * fastest;
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

    /** Whether any of the rows only pushes. */
    boolean areAny() {
        for (int row = 0; row < rows.count; row++) {
            if (isStop(row)) {
                return true;
            }
        }
        return false;
    }

    /**
     * Sets the targets of limits for a kick after which nothing drifts, as if h seconds were left.
     * A limit that carried a load stays loaded, whatever gap of round-off is left.
     */
    void aimAtRest(double h) {
        for (int row = 0; row < rows.count; row++) {
            if (rows.holdsPlace[row] && !rows.isEquation(row)) {
                rows.target[row] = load(row) > 0 ? 0 : -Math.max(0, rows.place[row]) / h;
            }
        }
    }

    /** Distance from its stop up to which a row counts as on it. */
    double tolerance(int row) {
        if (rows.joint[row] == NeutralRows.NONE) {
            return tolerance * width(row);
        }
        return tolerance * jointPlaces.size(row);
    }

    private double width(int row) {
        int at = rows.contact[row] * PackedContacts.STRIDE;
        return contacts.data[at + PackedContacts.WIDTH];
    }

    /** Impulse of a row in the last kick, N·s or N·m·s. */
    double load(int row) {
        return rows.joint[row] == NeutralRows.NONE
                ? contacts.data[rows.contact[row] * PackedContacts.STRIDE + rows.part[row]]
                : packed.impulseOf(rows.joint[row], rows.part[row]);
    }

    /** Whether a row's load is large enough to take part in the impacts of others at once. */
    boolean isLoaded(int row) {
        double pressing = pressing(row);
        return pressing > 0
                && (rows.joint[row] != NeutralRows.NONE || pressing >= PULLED * strongest);
    }

    /** Acceleration with which a row was pressed against its stop, m/s² or rad/s². */
    private double pressing(int row) {
        return kicked > 0 ? Math.max(0, load(row)) * rows.response[row] / kicked : 0;
    }

    /**
     * Approach speed from which on a row strikes its stop: its rebound would be visible, and it is
     * faster than the pressing acceleration makes it within a substep; m/s or rad/s.
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
                jointPlaces.of(row);
                pulled /= jointPlaces.size();
            } else {
                int a = joints.bodyA[slot];
                lift *= PairTolerances.width(bodies, a, joints.bodyB[slot]);
            }
        }
        double pressed = Math.max(pulled, pressing(row));
        double unseen = Math.sqrt(2 * pressed * lift);
        return Math.max(noise / rows.unit[row], Math.max(unseen, pressed * h));
    }

    /** Share of its approach speed with which a row rebounds. */
    double elasticity(int row) {
        if (rows.joint[row] != NeutralRows.NONE) {
            return rows.elasticity[row];
        }
        int at = rows.contact[row] * PackedContacts.STRIDE;
        return contacts.data[at + PackedContacts.ELASTICITY];
    }
}
