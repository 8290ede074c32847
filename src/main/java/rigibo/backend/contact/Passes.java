package rigibo.backend.contact;

import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.Correction;

/**
 * Advances an island that moves, substep by substep, by passes over its contacts. Where bodies
 * overlap they are moved apart, which gives them no speed.
 */
final class Passes {

    /**
     * Share of the island's fastest speed that does not count, however slowly it moves; less where
     * a substep is longer than the game's, and so what a kick gains in it.
     */
    private static final double QUIET = 0.03;

    /**
     * Substeps, cubed, for each pass that a substep may be given: twice the substeps halve what
     * counts some five times over, and each halving takes as many passes again.
     */
    private static final int CUBES_PER_PASS = 2;

    private static final int LEAST_PASSES = 16;

    /**
     * As many as the finest accuracy that has a name is given; what asks for more gains nothing.
     */
    private static final int MOST_PASSES = 2048;

    /** Passes in which overlap is taken back in a substep; the next one goes on. */
    private static final int PASSES_OVER_OVERLAP = 6;

    /**
     * Energy that the contacts of a substep may add, as a share of what a kick of the game's length
     * gives to bodies at rest.
     */
    private static final double NOISE = 0.1;

    private final Motions motions;
    private final PackedContacts contacts;
    private final Kick kick;
    private final EnergyGuard guard;
    private final ContactSweep sweep;
    private final OverlapSolver overlap;

    /** What a contact may miss its bounds by in a substep, in widths. */
    private final double missed;

    private final double quiet;
    private final double noise;
    private final boolean isCorrecting;
    private final int most;

    Passes(
            Motions motions,
            PackedContacts contacts,
            Kick kick,
            EnergyGuard guard,
            ContactSweep sweep,
            OverlapSolver overlap,
            Accuracy accuracy) {
        this.motions = motions;
        this.contacts = contacts;
        this.kick = kick;
        this.guard = guard;
        this.sweep = sweep;
        this.overlap = overlap;
        missed = missed(accuracy.impactTolerance());
        isCorrecting = accuracy.correction() == Correction.SOFT;
        int substeps = accuracy.substeps();
        double shorter = Math.min(1, substeps / (double) Accuracy.GAME.substeps());
        quiet = QUIET * shorter;
        noise = NOISE * shorter * shorter;
        int passes = Math.max(LEAST_PASSES, substeps * substeps * substeps / CUBES_PER_PASS);
        most = Math.min(MOST_PASSES, accuracy.velocityIterations() * passes);
    }

    /**
     * The tolerance of impacts to the power of three quarters: a thousandth at the game's accuracy.
     * Finer ones ask for more, but passes come nearer by a share each, not by a digit.
     */
    private static double missed(double tolerance) {
        double root = Math.sqrt(tolerance);
        return root * Math.sqrt(root);
    }

    /**
     * One substep of h seconds, in which nothing goes faster than {@code fastest} m/s by what
     * contacts carried, and that leaves nothing faster than a limit, m/s.
     */
    void advance(double h, int substep, double fastest, double limit) {
        hold(h, substep, fastest, limit);
        motions.drift(h);
        if (isCorrecting) {
            overlap.correctInPasses(h, substep, PASSES_OVER_OVERLAP);
        }
    }

    /** Keeps contacts from closing and sliding. */
    void hold(double h, int substep, double fastest, double limit) {
        sweep.run(h, substep, missed, quiet * fastest, most);
        guard.limitWork(noise * kick.energy(h));
        guard.limitSpeed(limit);
        contacts.addUpImpulses(1);
    }
}
