package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Effort;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.JointStore;

/**
 * The number of substeps that the springs of an island need. A spring oscillates at ω² =
 * k·J·M⁻¹·Jᵀ; composed substeps follow it to fourth order in ω·h. A spring that would need too many
 * substeps acts with its force at the end of the drift instead, which damps it within a few
 * substeps: by 1/(1 + ω·h) in each near a damping ratio of 1, where most is left.
 */
final class SpringSubsteps {

    /**
     * Phase of a spring in a second-order substep, rad; two of these are as long as a composed one.
     * The error of other joints and contacts is a share of its square.
     */
    private static final double MOST_PHASE = 0.25;

    /**
     * Most substeps, as a multiple of the usual number. A spring that needs more has a phase of at
     * least 4.2 rad in a usual substep, and 0.6 % of its amplitude after a step of four.
     */
    private static final int MOST_MORE = 6;

    private final JointStore joints;
    private final NeutralRows rows;
    private final PackedJoints packed;
    private final boolean areFollowed;

    SpringSubsteps(JointStore joints, NeutralRows rows, PackedJoints packed, Accuracy accuracy) {
        this.joints = joints;
        this.rows = rows;
        this.packed = packed;
        areFollowed = Effort.isThorough(accuracy);
    }

    /**
     * Number of substeps for a step of dt seconds of the island whose rows are written; at least
     * the usual one.
     */
    int count(double dt, int usual) {
        double most = areFollowed ? SpringRows.STIFF * MOST_MORE * usual : 0;
        double fastest = 0;
        for (int row = 0; row < rows.count; row++) {
            if (rows.joint[row] != NeutralRows.NONE && rows.part[row] == JointRows.SPRING) {
                double stiffness = joints.stiffness[packed.slot[rows.joint[row]]];
                double phase = dt * Math.sqrt(stiffness * rows.response[row]);
                fastest = phase <= most ? Math.max(fastest, phase) : fastest;
            }
        }
        double wanted = Math.ceil(fastest / MOST_PHASE);
        return (int) Math.max(usual, Math.min(MOST_MORE * usual, wanted));
    }
}
