package rigibo.backend;

import rigibo.backend.broadphase.FixtureSearch;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

/** What queries read: the live state of a pool, or a copy of it. */
interface Queried {

    Bodies bodies();

    Pairs pairs();

    /** Searches the fixtures; null where contacts are not declared. */
    FixtureSearch search();

    /** The handle of the body in a slot. */
    RigidBody handle(int slot);

    /** A number that is smaller for a body added earlier; slots are reused and do not tell. */
    int place(RigidBody body);
}
