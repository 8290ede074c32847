package rigibo.fuzz.program;

import rigibo.backend.Pool;
import rigibo.backend.RayHit;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;

import java.util.List;
import java.util.Optional;

/** Receives the queries of a program and their answers, to check them. */
public interface Witness {

    /** A witness that checks nothing. */
    Witness NONE = new Witness() {};

    /** Called before a step. */
    default void beforeStep(Pool pool) {}

    /** Called after a step of dt s. */
    default void stepped(Pool pool, double dt) {}

    /** Called when the program continues with a restored pool. */
    default void restored(Pool pool) {}

    /** Called with the answer to what is at a point, m. */
    default void foundAt(Pool pool, double x, double y, Optional<RigidBody> found) {}

    /** Called with the answer to what a ray hits, m. */
    default void metByRay(
            Pool pool, double fromX, double fromY, double toX, double toY, Optional<RayHit> hit) {}

    /** Called with the answer to what overlaps a box, m. */
    default void foundIn(Pool pool, Aabb box, List<RigidBody> found) {}

    /** Called when an altered snapshot was restored nevertheless. */
    default void restoredAltered(Pool pool, int bytes) {}
}
