package rigibo.backend.contact.hold;

import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.OwnLoads;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.contact.solve.Halfway;
import rigibo.backend.contact.solve.OverlapSolver;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.DataStorage;

/**
 * Finds islands at rest by the cheapest test that succeeds: by the forces that they already carry,
 * by loads handed down from above, or by the solution after they were solved.
 */
public final class Repose {

    /** Highest speed of a still body, as a multiple of the allowed residual. */
    private static final double QUIET = 16;

    /**
     * Highest speed of a calm body, as a share of the speed that its own pull gives it in a step.
     */
    private static final double CALM = 0.25;

    private final Kick kick;
    private final RowBuilder builder;
    private final int substeps;
    private final Equilibrium equilibrium;
    private final LoadsFromAbove loads;
    private final Stillness stillness;
    private final Halfway before;

    /** Tests piles that {@code builder} packs; {@code overlap} is null if it is not corrected. */
    public Repose(
            DataStorage data,
            Motions motions,
            PackedContacts contacts,
            OwnLoads own,
            OverlapSolver overlap,
            Kick kick,
            RowBuilder builder,
            Accuracy accuracy) {
        this.kick = kick;
        this.builder = builder;
        substeps = accuracy.substeps();
        equilibrium = new Equilibrium(data, accuracy);
        loads = new LoadsFromAbove(data.bodies, motions, contacts, accuracy);
        stillness = new Stillness(data.bodies, motions, contacts, own, overlap, kick);
        before = new Halfway(motions, contacts);
    }

    /**
     * Whether an island that is not packed yet rests for a step of {@code dt} seconds on the forces
     * it carried at the end of the last step, apart from removal of overlap.
     */
    public boolean lasts(int island, double dt) {
        return equilibrium.lasts(island, dt) && isPulledSteadily(island, dt);
    }

    /** Whether the last tested island has overlap to be removed. */
    public boolean isOverlapping() {
        return equilibrium.isOverlapping();
    }

    private boolean isPulledSteadily(int island, double dt) {
        if (!kick.mayChange()) {
            return true;
        }
        builder.packBodies(island);
        double h = dt / substeps;
        return isPulledSteadily(h, h, substeps);
    }

    /** Whether forces that vary along the path stay the same up to the end of the step. */
    private boolean isPulledSteadily(double first, double h, int kicks) {
        return kick.isSteady(first, h, kicks, Equilibrium.UNHELD * kick.strongest());
    }

    /** Starts the step of the packed island, before its first kick. */
    public void begin() {
        stillness.begin();
    }

    /**
     * Whether no body of the packed island is faster than {@link #QUIET} times a share of the speed
     * that its own pull would give it in a step of {@code dt} seconds.
     */
    public boolean isStill(double dt, double share) {
        return stillness.isEveryBodyStill(dt, QUIET * share);
    }

    /** Whether every body is calm, that is, slower than {@link #CALM} allows. */
    public boolean isCalm(double dt) {
        return stillness.isEveryBodyStill(dt, CALM);
    }

    /**
     * Whether the packed island, which was still, rests on loads handed down from above in its
     * first substep, whose kick lasted {@code kicked} seconds. If not, it is restored.
     */
    public boolean isCarried(double start, double h, int substeps, double kicked) {
        before.begin();
        boolean isCarried =
                loads.handDown(kicked)
                        && isFound(start, h, substeps, kicked)
                        && isPulledSteadily(start + h, h, substeps);
        if (!isCarried) {
            before.takeBack();
        }
        return isCarried;
    }

    /** Stops the held bodies of an island that does not rest, after a kick of {@code kicked} s. */
    public void haltHeld(double kicked) {
        stillness.haltHeld(kicked);
    }

    /** Whether the solution of the first substep shows that the packed island rests. */
    public boolean isFound(double start, double h, int substeps, double kicked) {
        return stillness.isAtRest(start, h, substeps, kicked);
    }
}
