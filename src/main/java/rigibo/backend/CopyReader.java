package rigibo.backend;

import rigibo.backend.broadphase.FixtureSearch;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

/** A copied state as one reader queries it, with scratch of its own. */
final class CopyReader implements Queried {

    private final CopiedState state;
    private final FixtureSearch search;

    CopyReader(CopiedState state) {
        this.state = state;
        search = state.hasFixtures ? state.fixtures.search() : null;
    }

    @Override
    public Bodies bodies() {
        return state.columns.bodies;
    }

    @Override
    public Pairs pairs() {
        return state.columns.pairs;
    }

    @Override
    public FixtureSearch search() {
        return search;
    }

    @Override
    public RigidBody handle(int slot) {
        return state.roll.atSlot(slot);
    }

    @Override
    public int place(RigidBody body) {
        return state.roll.place(body.everSlot());
    }
}
