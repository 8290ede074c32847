package rigibo.backend.contact.joint;

import rigibo.backend.geometry.Exponential;
import rigibo.backend.storage.JointStore;

/**
 * Springs and dampers as rows with compliance. A spring that oscillates slowly relative to the
 * substep acts with its present force, j = −L·(k·x + c·(w₀ + w₁)/2), which is symmetric in time and
 * keeps the energy of a leapfrog. A stiffer one acts with the force at the end of the drift, j =
 * −L·(k·(x + h·w₁) + c·w₁), which is stable at any stiffness, rests at the same place and only
 * loses energy (Baraff and Witkin, Large steps in cloth simulation, 1998).
 */
final class SpringRows {

    /** Phase of a spring in a substep from which on it counts as stiff, rad. */
    static final double STIFF = 0.7;

    private final JointStore joints;
    private final NeutralRows rows;

    /** Lengths of the kick and of the drift after it, s. */
    private double kick;

    private double drift;

    /** The joint of the row that was written last, how far it is from rest, and how. */
    private int slot;

    private double away;
    private boolean isImplicit;

    SpringRows(JointStore joints, NeutralRows rows) {
        this.joints = joints;
        this.rows = rows;
    }

    /** Whether one of the rows written since is stiff. */
    boolean areAnyStiff;

    void begin(double kickLength, double driftLength) {
        kick = kickLength;
        drift = driftLength;
        areAnyStiff = false;
    }

    /** Sets the joint of the next row and its displacement from rest, m or rad. */
    void write(int joint, double fromRest) {
        slot = joint;
        away = fromRest;
        isImplicit = false;
    }

    /** Sets the joint of the next row, whose spring is solved implicitly. */
    void writeImplicit(int joint, double fromRest) {
        write(joint, fromRest);
        isImplicit = true;
    }

    /** Writes target and compliance of a finished row, before velocities are kicked. */
    void finish(int row) {
        double k = joints.stiffness[slot];
        double c = joints.damping[slot];
        double phase = drift * drift * k * rows.response[row];
        if (isImplicit || phase > STIFF * STIFF) {
            double length = Math.abs(drift);
            areAnyStiff = true;
            rows.give[row] = 1 / (kick * (c + length * k));
            rows.target[row] = -k * away / (c + length * k);
        } else if (c > 0) {
            // If nothing else acts, this is the exact decay rather than an approximation.
            double decay = kick * c * rows.response[row] / 2;
            double half = decay == 0 ? 0 : Exponential.tanh(decay) / rows.response[row];
            rows.give[row] = 1 / half;
            rows.target[row] = -rows.speed(row) - kick * k * away / half;
        } else {
            rows.lower[row] = -kick * k * away;
            rows.upper[row] = rows.lower[row];
        }
    }
}
