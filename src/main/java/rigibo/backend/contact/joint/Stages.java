package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Effort;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;

/**
 * The parts of a substep. Usually there is one, of second order. From GAME on, islands that only
 * equations hold and that lose no energy have five, of which the middle one goes back in time: with
 * p = 1/(4 − ∛4) for the others the error is of fourth order (M. Suzuki, Fractal decomposition of
 * exponential operators, 1990), for any symmetric step.
 */
public final class Stages {

    /** 1/(4 − ∛4). */
    private static final double FORWARD = 0.41449077179437573714;

    private static final double[] ONE = {1};
    private static final double[] FIVE = {
        FORWARD, FORWARD, 1 - 4 * FORWARD, FORWARD, FORWARD,
    };

    private final Bodies bodies;
    private final Motions motions;
    private final boolean mayCompose;

    private double[] shares = ONE;

    public Stages(Bodies bodies, Motions motions, Accuracy accuracy) {
        this.bodies = bodies;
        this.motions = motions;
        mayCompose = Effort.isThorough(accuracy);
    }

    /** Begins an island whose substeps have one part each. */
    public void begin() {
        shares = ONE;
    }

    /** Begins substeps with five parts each, if that is allowed. */
    public void beginComposed() {
        shares = mayCompose ? FIVE : ONE;
    }

    /** Whether islands may have composed substeps. */
    public boolean mayCompose() {
        return mayCompose;
    }

    /** Number of parts of a substep. */
    public int count() {
        return shares.length;
    }

    /** Length of a part of a substep of h seconds, s. */
    public double length(int part, double h) {
        return shares[part] * h;
    }

    /** Whether any part goes back in time. */
    public boolean areComposed() {
        return shares.length > 1;
    }

    /**
     * Moves the velocities from one time to another, both in s after the step's start, which may go
     * back. A body that joined the island in between is kicked only from when it joined.
     */
    public void accelerate(double from, double to) {
        double[] m = motions.data;
        for (int entry = 1; entry < motions.count; entry++) {
            int at = entry * Motions.STRIDE;
            int slot = motions.slots[entry];
            if (m[at + Motions.INVERSE_MASS] > 0) {
                double length = to - Math.max(from, bodies.pileTime[slot]);
                m[at + Motions.VX] += length * bodies.accelerationX[slot];
                m[at + Motions.VY] += length * bodies.accelerationY[slot];
                if (motions.turns) {
                    m[at + Motions.SPIN] += length * bodies.angularAcceleration[slot];
                }
            }
        }
    }
}
