package rigibo.backend.contact;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.contact.row.IslandForces;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;

/** Advances all islands by one step. */
public final class ContactStage {

    private final Islands islands;
    private final Counters counters;
    private final IslandSolver solver;
    private final Bodies bodies;
    private final DataStorage data;
    private final Narrowphase narrowphase;

    /** Solves islands with joints or locked axes; null if there cannot be any. */
    private final JointedIslands jointed;

    /**
     * A stage for the declared effects at an accuracy; {@code forces} are those that vary along the
     * path, null if there are none.
     */
    public ContactStage(
            DataStorage data,
            Narrowphase narrowphase,
            Effects effects,
            Accuracy accuracy,
            IslandForces forces) {
        bodies = data.bodies;
        this.data = data;
        this.narrowphase = narrowphase;
        islands = data.islands;
        counters = data.counters;
        solver = new IslandSolver(data, narrowphase, effects, accuracy, forces);
        jointed =
                data.hasAssemblies()
                        ? new JointedIslands(data, narrowphase, effects, accuracy, forces)
                        : null;
    }

    /** Advances every island to the end of a step of {@code dt} seconds. */
    public void solve(double dt) {
        solveIslands(dt);
        narrowphase.giveOuterBack();
        if (data.hits != null) {
            data.hits.tellExpected(bodies, data.pairs);
        }
    }

    private void solveIslands(double dt) {
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
            if (islands.areJoined(island) || isAnyLocked(island)) {
                jointed.solve(island, dt);
            } else {
                solver.solve(island, dt);
            }
        }
        counters.take(solver.work());
        counters.take(jointed.work());
    }

    /** Whether a body of an island has a locked axis. */
    private boolean isAnyLocked(int island) {
        boolean isAny = false;
        int end = bodies.lockedX == null ? 0 : islands.bodyStart[island + 1];
        for (int i = islands.bodyStart[island]; !isAny && i < end; i++) {
            isAny = bodies.isHeldByAxis(islands.bodies[i]);
        }
        return isAny;
    }
}
