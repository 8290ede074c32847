package rigibo.backend.contact;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.contact.row.IslandForces;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Counters;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Islands;
import rigibo.backend.team.Team;

/** Solves islands one after the other: the solvers of one worker. */
final class IslandWorker {

    /** The pool's data for this worker, with lists of its own if islands are shared. */
    final DataStorage data;

    private final Islands islands;
    private final Bodies bodies;
    private final IslandSolver solver;

    /** Solves islands with joints or locked axes; null if there cannot be any. */
    private final JointedIslands jointed;

    /**
     * A worker for the declared effects at an accuracy; {@code forces} are those that vary along
     * the path, null if there are none. A team helps it with large islands; null for none.
     */
    IslandWorker(
            DataStorage data,
            Narrowphase narrowphase,
            Effects effects,
            Accuracy accuracy,
            IslandForces forces,
            Team team) {
        this.data = data;
        islands = data.islands;
        bodies = data.bodies;
        solver = new IslandSolver(data, narrowphase, effects, accuracy, forces, team);
        jointed =
                data.hasAssemblies()
                        ? new JointedIslands(data, narrowphase, effects, accuracy, forces)
                        : null;
    }

    /** Advances an island to the end of a step of {@code dt} seconds. */
    void solve(int island, double dt) {
        if (jointed != null && (islands.areJoined(island) || isAnyLocked(island))) {
            jointed.solve(island, dt);
        } else {
            solver.solve(island, dt);
        }
    }

    /** Adds the work since the last call to the step's counters. */
    void tellWork(Counters counters) {
        counters.take(solver.work());
        if (jointed != null) {
            counters.take(jointed.work());
        }
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
