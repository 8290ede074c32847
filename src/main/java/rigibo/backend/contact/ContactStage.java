package rigibo.backend.contact;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.contact.row.IslandForces;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;

/** Advances all islands by one step. */
public final class ContactStage {

    private final Islands islands;
    private final Counters counters;
    private final IslandSolver solver;

    /** Of islands with joints, or null where none are declared. */
    private final JointedIslands jointed;

    /**
     * A stage of what is declared, at an accuracy; {@code forces} change along the way, null where
     * there are none.
     */
    public ContactStage(
            DataStorage data,
            Narrowphase narrowphase,
            Effects effects,
            Accuracy accuracy,
            IslandForces forces) {
        islands = data.islands;
        counters = data.counters;
        solver = new IslandSolver(data, narrowphase, effects, accuracy, forces);
        jointed =
                data.joints == null
                        ? null
                        : new JointedIslands(data, narrowphase, effects, accuracy, forces);
    }

    /** Advances every island to the end of a step of {@code dt} seconds. */
    public void solve(double dt) {
        if (jointed != null) {
            solveJointed(dt);
            return;
        }
        for (int island = 0; island < islands.count; island++) {
            solver.solve(island, dt);
        }
        counters.take(solver.work());
    }

    private void solveJointed(double dt) {
        for (int island = 0; island < islands.count; island++) {
            if (islands.areJoined(island)) {
                jointed.solve(island, dt);
            } else {
                solver.solve(island, dt);
            }
        }
        counters.take(solver.work());
        counters.take(jointed.work());
    }
}
