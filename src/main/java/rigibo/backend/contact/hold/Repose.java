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
 * Finds islands at rest by the cheapest test that tells: by the forces that they carry already, by
 * loads handed down from above, or, after they were solved, by the solution.
 */
public final class Repose {

    /** Fastest speed of a still body, as a multiple of what counts as solved. */
    private static final double QUIET = 16;

    /** Fastest speed of a calm body, as a share of what its own pull gives it in a step. */
    private static final double CALM = 0.25;

    private final Kick kick;
    private final RowBuilder builder;
    private final int substeps;
    private final Equilibrium equilibrium;
    private final LoadsFromAbove loads;
    private final Stillness stillness;
    private final Halfway before;

    /** Of piles that {@code builder} packs; {@code overlap} is null where none is taken back. */
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
        loads = new LoadsFromAbove(data.bodies, motions, contacts);
        stillness = new Stillness(data.bodies, motions, contacts, own, overlap, kick);
        before = new Halfway(motions, contacts);
    }

    /**
     * Whether an island that is not packed yet rests for a step of {@code dt} seconds on what it
     * carried at the end of the last, but for overlap that is taken back.
     */
    public boolean lasts(int island, double dt) {
        return equilibrium.lasts(island, dt) && isPulledSteadily(island, dt);
    }

    /** Whether there is overlap to take back in the island that was asked for last. */
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

    /** Whether forces that change along the way stay the same up to the end of the step. */
    private boolean isPulledSteadily(double first, double h, int kicks) {
        return kick.isSteady(first, h, kicks, Equilibrium.UNHELD * kick.strongest());
    }

    /** Begins the step of the packed island, which has not been kicked yet. */
    public void begin() {
        stillness.begin();
    }

    /**
     * Whether no body of the packed island goes faster than a multiple of a share of what its own
     * pull would give it in a step of {@code dt} seconds.
     */
    public boolean isStill(double dt, double share) {
        return stillness.isEveryBodyStill(dt, QUIET * share);
    }

    /** Whether every body is calm: slower than a share of what its own pull gives it in a step. */
    public boolean isCalm(double dt) {
        return stillness.isEveryBodyStill(dt, CALM);
    }

    /**
     * Whether the packed island, which was still, rests on loads handed down from above, in the
     * first of its substeps, whose kick lasted {@code kicked} seconds; if not it is as it was.
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

    /** Stops whoever is held where others are not, after a kick of {@code kicked} seconds. */
    public void haltHeld(double kicked) {
        stillness.haltHeld(kicked);
    }

    /** Whether the packed island was solved to rest, in the first of its substeps. */
    public boolean isFound(double start, double h, int substeps, double kicked) {
        return stillness.isAtRest(start, h, substeps, kicked);
    }
}
