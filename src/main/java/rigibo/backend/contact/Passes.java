package rigibo.backend.contact;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Correction;

/**
 * Advances a pile too large to be solved whole by passes over its contacts: it gives way under its
 * load and pushes back.
 */
final class Passes {

    private final Motions motions;
    private final NormalSolver normals;
    private final DeclaredRows declared;
    private final EnergyGuard guard;
    private final SoftPush soft = new SoftPush();
    private final boolean isCorrecting;
    private final int iterations;

    Passes(
            Motions motions,
            NormalSolver normals,
            DeclaredRows declared,
            EnergyGuard guard,
            Accuracy accuracy) {
        this.motions = motions;
        this.normals = normals;
        this.declared = declared;
        this.guard = guard;
        isCorrecting = accuracy.correction() == Correction.SOFT;
        iterations = accuracy.velocityIterations();
    }

    /** One substep of h seconds that leaves nothing faster than a limit, m/s. */
    void advance(double h, int substep, boolean isRound, double limit) {
        declared.strikeApart(h, substep);
        pushApart(h, substep);
        guard.limitSpeed(limit);
        motions.drift(h);
        hold(h, substep, isRound, limit);
    }

    private void pushApart(double h, int substep) {
        double kickLength = substep == 0 ? h / 2 : h;
        for (int i = 0; i < iterations; i++) {
            if (isCorrecting) {
                normals.push(h, kickLength, substep, soft);
            } else {
                normals.forth(h, substep);
            }
        }
    }

    /**
     * Keeps contacts from closing and sliding. What is not of discs is passed over both ways: loads
     * that reach the ground in one substep come back up in it, and a high stack does not breathe.
     */
    void hold(double h, int substep, boolean isRound, double limit) {
        for (int left = iterations; left > 0; left--) {
            if (!isRound) {
                normals.forth(h, substep);
            }
            declared.relax(normals, h, substep, left == 1);
        }
        guard.limitSpeed(limit);
    }
}
