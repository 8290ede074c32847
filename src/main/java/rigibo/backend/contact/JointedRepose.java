package rigibo.backend.contact;

import rigibo.backend.contact.hold.Equilibrium;
import rigibo.backend.contact.joint.JointsAtRest;
import rigibo.backend.contact.row.IslandResults;
import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.RowBuilder;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;

/**
 * Finds islands with joints that rest: the forces that contacts and joints carried when the last
 * step ended hold every body.
 */
final class JointedRepose {

    private final Bodies bodies;
    private final Islands islands;
    private final Kick kick;
    private final RowBuilder builder;
    private final IslandResults results;
    private final Equilibrium equilibrium;
    private final JointsAtRest joints;
    private final int substeps;

    JointedRepose(
            DataStorage data,
            Motions motions,
            Kick kick,
            RowBuilder builder,
            IslandResults results,
            Accuracy accuracy) {
        bodies = data.bodies;
        islands = data.islands;
        this.kick = kick;
        this.builder = builder;
        this.results = results;
        equilibrium = new Equilibrium(data, accuracy);
        joints = new JointsAtRest(data, motions, builder, accuracy);
        substeps = accuracy.substeps();
    }

    /** Whether an island rests for a step of {@code dt} seconds. */
    boolean lasts(int island, double dt) {
        if (!equilibrium.mayLast(island, dt) || !joints.areStanding(island)) {
            return false;
        }
        builder.packBodies(island);
        double h = dt / substeps;
        return joints.goOn(island, dt, equilibrium)
                && equilibrium.isHeld(island, dt, h / 2)
                && isPulledSteadily(h);
    }

    /** Whether forces that vary along the path stay the same up to the end of the step. */
    private boolean isPulledSteadily(double h) {
        return !kick.mayChange()
                || kick.isSteady(h, h, substeps, Equilibrium.UNHELD * kick.strongest());
    }

    /** Keeps an island at rest for a step of {@code dt} seconds. */
    void goOn(int island, double dt) {
        for (int i = islands.bodyStart[island]; i < islands.bodyStart[island + 1]; i++) {
            bodies.halt(islands.bodies[i]);
        }
        results.goOn(island, dt);
        joints.tell(dt);
    }
}
