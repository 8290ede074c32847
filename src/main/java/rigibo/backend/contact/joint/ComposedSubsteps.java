package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Effort;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.JointKind;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointStore;

/**
 * The number of substeps that an island needs. The error of a composed substep of h seconds grows
 * with (ωh)⁴, where ω is the fastest of the island's rotations, oscillations and vibrations; that
 * of a plain one grows with (ωh)², which is enough if damping makes the island forget its errors.
 */
final class ComposedSubsteps {

    /**
     * Phase of the fastest motion in a substep, rad, as a multiple of the fourth root of the
     * tolerance. The error of a harmonic oscillation in five parts is then at most a hundredth of
     * the tolerance per period.
     */
    private static final double MOST_PHASE = 1.25;

    /**
     * Largest phase ωh of a plain substep in a damped or driven island, rad, as a multiple of the
     * square root of the tolerance: 0.25 rad at GAME, with an error of the period of 0.26 %.
     */
    private static final double MOST_PHASE_IF_DAMPED = 25;

    private final JointStore joints;
    private final Motions motions;
    private final NeutralRows rows;
    private final JointPlaces jointPlaces;
    private final PackedJoints packed;
    private final TautSubsteps taut;
    private final double mostPhase;
    private final double mostIfDamped;

    ComposedSubsteps(
            DataStorage data,
            Motions motions,
            NeutralRows rows,
            JointPlaces jointPlaces,
            PackedJoints packed,
            TautSubsteps taut,
            Accuracy accuracy) {
        joints = data.jointsOrNone();
        this.motions = motions;
        this.rows = rows;
        this.jointPlaces = jointPlaces;
        this.packed = packed;
        this.taut = taut;
        // A number of substeps that changes within an oscillation leaves a trend of energy, which
        // EXACT does not allow.
        double tolerance = Effort.isExact(accuracy) ? 0 : accuracy.impactTolerance();
        double root = Math.sqrt(tolerance);
        mostPhase = MOST_PHASE * Math.sqrt(root);
        mostIfDamped = MOST_PHASE_IF_DAMPED * root;
    }

    /**
     * Number of substeps of the packed island, whose rows are written, for a step of dt seconds.
     */
    int count(int island, double dt, int most) {
        if (most == 1 || mostPhase == 0) {
            return most;
        }
        return (int) Math.min(most, Math.max(1, Math.ceil(fastest(island) * dt / mostPhase)));
    }

    /**
     * Number of plain substeps that the packed island needs, from {@code least} to {@code most}. It
     * is {@code most} if nothing damps the island: a number that changes within an oscillation
     * would leave a trend of energy, of some thousandths in a hundred periods.
     */
    int countPlainly(int island, double dt, int least, int most) {
        if (most == 1 || mostPhase == 0 || !isAnyDamped()) {
            return most;
        }
        double wanted = Math.ceil(fastest(island) * dt / mostIfDamped);
        return (int) Math.min(most, Math.max(least, wanted));
    }

    /** Whether the island's errors decay, because a damper or a motor acts in it. */
    private boolean isAnyDamped() {
        for (int i = 0; i < packed.count; i++) {
            int slot = packed.slot[i];
            if (joints.damping[slot] > 0 || joints.motorMost[slot] > 0) {
                return true;
            }
        }
        return false;
    }

    /** The fastest rotation, oscillation or vibration in the packed island, rad/s. */
    private double fastest(int island) {
        double rate = Math.max(turning(), Math.sqrt(taut.square(island)));
        for (int row = 0; row < rows.count; row++) {
            if (rows.joint[row] != NeutralRows.NONE) {
                rate = Math.max(rate, rate(row));
            }
        }
        return rate;
    }

    /** The fastest spin of a body, rad/s. */
    private double turning() {
        double most = 0;
        for (int entry = 1; entry < motions.count; entry++) {
            most = Math.max(most, Math.abs(motions.data[entry * Motions.STRIDE + Motions.SPIN]));
        }
        return most;
    }

    /** How fast a row's motion oscillates or decays, or its direction turns, rad/s. */
    private double rate(int row) {
        int joint = rows.joint[row];
        int slot = packed.slot[joint];
        if (rows.part[row] == JointRows.SPRING) {
            double swing = Math.sqrt(joints.stiffness[slot] * rows.response[row]);
            return Math.max(swing, joints.damping[slot] * rows.response[row] / 2);
        }
        if (joints.kind[slot] == JointKind.PULLEY.ordinal()) {
            return Double.POSITIVE_INFINITY;
        }
        return joints.kind[slot] == JointKind.DISTANCE.ordinal() ? turning(row, joint, slot) : 0;
    }

    /**
     * Upper bound on the rotation of a rod, rad/s; its motion along the rod is not told from that
     * across it.
     */
    private double turning(int row, int joint, int slot) {
        int a = packed.offsetA[joint];
        int b = packed.offsetB[joint];
        double[] m = motions.data;
        double x = m[b + Motions.VX] - m[a + Motions.VX];
        double y = m[b + Motions.VY] - m[a + Motions.VY];
        double onA = joints.armA(slot);
        double onB = joints.armB(slot);
        double turned = onA * Math.abs(m[a + Motions.SPIN]) + onB * Math.abs(m[b + Motions.SPIN]);
        double along = jointPlaces.along(row);
        return along > 0 ? (length(x, y) + turned) / along : Double.POSITIVE_INFINITY;
    }

    private static double length(double x, double y) {
        return Math.sqrt(x * x + y * y);
    }
}
