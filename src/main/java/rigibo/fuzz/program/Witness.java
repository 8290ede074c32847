package rigibo.fuzz.program;

import rigibo.backend.Pool;
import rigibo.backend.RayHit;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Aabb;

import java.util.List;
import java.util.Optional;

/** Is told what a program asks and what it is answered, in order to judge it. */
public interface Witness {

    /** Who looks at nothing. */
    Witness NONE = new Witness() {};

    /** A step is about to begin. */
    default void beforeStep(Pool pool) {}

    /** A step of dt in s was made. */
    default void stepped(Pool pool, double dt) {}

    /** The program goes on with a pool that was just restored. */
    default void restored(Pool pool) {}

    /** What is at a point, m. */
    default void foundAt(Pool pool, double x, double y, Optional<RigidBody> found) {}

    /** What a ray meets on its way, m. */
    default void metByRay(
            Pool pool, double fromX, double fromY, double toX, double toY, Optional<RayHit> hit) {}

    /** What reaches into a box, m. */
    default void foundIn(Pool pool, Aabb box, List<RigidBody> found) {}

    /** A snapshot of so many bytes was altered and restored all the same. */
    default void restoredAltered(Pool pool, int bytes) {}
}
