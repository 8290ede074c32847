package rigibo.backend.contact.joint;

import rigibo.backend.geometry.Exponential;
import rigibo.backend.storage.JointStore;

/**
 * Springs and dampers as rows with compliance. A spring that oscillates slowly relative to the
 * substep acts with its present force, j = −L·k·x, which is symmetric in time and keeps the energy
 * of a leapfrog. If it is damped, j = −L·k·x − c′·(w₀ + w₁)/2 − m′·(w₁ − w₀), where c′ and m′ make
 * a body that nothing else moves follow the truth to round-off ({@link DampedSwing}); at rest
 * neither acts, so that it sags by m·g/k. A stiffer one acts with the force at the end of the
 * drift, j = −L·(k·(x + h·w₁) + c·w₁), which is stable at any stiffness, rests at the same place
 * and only loses energy (Baraff and Witkin, Large steps in cloth simulation, 1998).
 */
final class SpringRows {

    /** Phase of a spring in a substep from which on it counts as stiff, rad. */
    static final double STIFF = 0.7;

    /**
     * Phase in a drift below which the round-off of the exact swing exceeds the error of an exact
     * decay, rad.
     */
    private static final double SLOW = 1e-2;

    /** Decay within a drift from which a body creeps instead of swinging. */
    private static final double CREEPS = 20;

    private final JointStore joints;
    private final NeutralRows rows;

    /**
     * Lengths of the kick and of a substep's drift, s, and of the drifts before and after it; some
     * of a composed substep are negative.
     */
    private double kick;

    private double drift;
    private double before;
    private double after;

    private final DampedSwing swing = new DampedSwing();

    /**
     * The joint of the next row; its displacement from rest, m or rad; and whether its spring is
     * implicit.
     */
    private int slot;

    private double away;
    private boolean isImplicit;

    SpringRows(JointStore joints, NeutralRows rows) {
        this.joints = joints;
        this.rows = rows;
    }

    /** Whether any row written since {@link #begin} is stiff, and whether the last one is. */
    boolean areAnyStiff;

    boolean isStiff;

    /** Begins with rows for a kick in a substep of h seconds, after which bodies may drift. */
    void begin(double kickLength, double h, boolean isLast) {
        kick = kickLength;
        drift = h;
        before = isLast ? 2 * kick : 2 * kick - h;
        after = isLast ? 0 : h;
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
        isStiff = isImplicit || phase > STIFF * STIFF;
        if (isStiff) {
            double length = Math.abs(drift);
            areAnyStiff = true;
            rows.give[row] = 1 / (kick * (c + length * k));
            rows.target[row] = -k * away / (c + length * k);
        } else if (c > 0) {
            damp(row, k, c * rows.response[row] / 2);
        } else {
            rows.lower[row] = -kick * k * away;
            rows.upper[row] = rows.lower[row];
        }
    }

    /** Writes a damped spring that decays at a rate in 1/s, if nothing else acts. */
    private void damp(int row, double k, double decay) {
        double response = rows.response[row];
        double square = k * response;
        double kept;
        double inertia;
        // A part may end after any time, however short, at an impact.
        double longest = Math.max(Math.abs(before), Math.abs(after));
        if (square * longest * longest > SLOW * SLOW && decay * longest < CREEPS) {
            swing.between(square, decay, before, after);
            kept = swing.kept;
            inertia = kick * square / swing.pulled;
        } else {
            // The exact decay, if nothing else acts.
            double slows = Exponential.tanh(kick * decay);
            inertia = 1 + slows;
            kept = (1 - slows) / inertia;
        }
        // Alone it does inertia·w₁ = inertia·kept·w₀ − L·k·x·response, and w₁ = w₀ + response·j.
        double resists = inertia - 1;
        rows.give[row] = response / resists;
        rows.target[row] =
                (-rows.speed(row) * (1 - inertia * kept) - kick * square * away) / resists;
    }
}
