package rigibo.backend.contact.joint;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.JointStore;

/**
 * How many substeps the springs of an island need. A spring swings at ω² = k·J·M⁻¹·Jᵀ; composed
 * substeps follow it to the fourth order in ω·h. One that would need too many is asked for its
 * force at the end of the drift instead, which damps it away within a few substeps: the factor is
 * 1/(1 + ω·h) in each for a damping ratio near 1, where that leaves the most.
 */
final class SpringSubsteps {

    /**
     * rad of a spring's phase in a substep of second order, two of which are as long as a composed
     * one: with a damping ratio of 0.4 what that errs by is then 10⁻³ of the envelope.
     */
    private static final double MOST_PHASE = 0.25;

    /**
     * Times as many substeps as usual, at most. A spring that needs more has 4.2 rad or more in a
     * usual substep, and after a step of four of them 0.6 % of its swing.
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
        areFollowed = accuracy.substeps() >= Accuracy.GAME.substeps();
    }

    /**
     * Substeps of the island whose rows are written, for a step of dt seconds, usually as usual.
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
