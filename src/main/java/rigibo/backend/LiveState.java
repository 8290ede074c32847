package rigibo.backend;

import rigibo.backend.broadphase.Broadphase;
import rigibo.backend.broadphase.FixtureSearch;
import rigibo.backend.step.StepPlan;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.Pairs;

/** The state of a pool as it is now, for queries by the thread that steps. */
final class LiveState implements Queried {

    private final Pool pool;
    private final DataStorage data;
    private final StepPlan plan;

    LiveState(Pool pool, DataStorage data, StepPlan plan) {
        this.pool = pool;
        this.data = data;
        this.plan = plan;
    }

    @Override
    public Bodies bodies() {
        return data.bodies;
    }

    @Override
    public Pairs pairs() {
        return data.pairs;
    }

    DataStorage data() {
        return data;
    }

    /** The broad phase; null where contacts are not declared. */
    Broadphase broadphase() {
        return plan.broadphase();
    }

    @Override
    public FixtureSearch search() {
        Broadphase broadphase = plan.broadphase();
        return broadphase == null ? null : broadphase.search();
    }

    @Override
    public RigidBody handle(int slot) {
        return pool.handle(slot);
    }

    @Override
    public int place(RigidBody body) {
        return body.place;
    }
}
