package rigibo.backend.contact;

import rigibo.backend.collision.Narrowphase;
import rigibo.backend.contact.row.IslandForces;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.team.Team;

/** Advances all islands by one step. */
public final class ContactStage {

    private final DataStorage data;
    private final Narrowphase narrowphase;
    private final IslandWorker alone;

    /** Shares islands among the workers of a team; null if there is one worker. */
    private final SharedIslands shared;

    /**
     * A stage for the declared effects at an accuracy.
     *
     * @param forces those that vary along the path, null if there are none; where there are,
     *     islands are not shared, since they may call functions of the caller
     * @param team null for one worker
     */
    public ContactStage(
            DataStorage data,
            Narrowphase narrowphase,
            Effects effects,
            Accuracy accuracy,
            IslandForces forces,
            Team team) {
        this.data = data;
        this.narrowphase = narrowphase;
        alone = new IslandWorker(data, narrowphase, effects, accuracy, forces, team);
        boolean mayShare = team != null && forces == null;
        shared = mayShare ? new SharedIslands(data, effects, accuracy, team) : null;
    }

    /** Advances every island to the end of a step of {@code dt} seconds. */
    public void solve(double dt) {
        if (shared != null && !narrowphase.isLending() && shared.prepare()) {
            shared.solve(dt);
        } else {
            for (int island = 0; island < data.islands.count; island++) {
                alone.solve(island, dt);
            }
            alone.tellWork(data.counters);
        }
        narrowphase.giveOuterBack();
        if (data.hits != null) {
            data.hits.tellExpected(data.bodies, data.pairs);
        }
    }
}
