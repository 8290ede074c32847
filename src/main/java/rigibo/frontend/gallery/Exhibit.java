package rigibo.frontend.gallery;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Scene;

/**
 * A small program that the gallery shows: the effects that it declares, the bodies that it adds,
 * and optionally what it does before each step. It needs only the engine's public face.
 *
 * <p>The gallery finds every class named in a line of {@code
 * META-INF/services/rigibo.frontend.gallery.Exhibit}. It makes an instance with the constructor
 * without parameters each time the scene begins, so that fields may hold the exhibit's bodies.
 * Title and sentence stand in {@code rigibo/gallery.properties}; without them the gallery shows the
 * name of the class.
 */
public interface Exhibit {

    /** What the scene calls for. */
    default Effects effects() {
        return Effects.usual();
    }

    /** Adds the bodies to a pool that has none. */
    void build(Pool pool);

    /** Before each step; what the last one did can be read here. */
    default void beforeStep(Pool pool) {}

    /** The right button went down at a point of the world, m. */
    default void act(Pool pool, double x, double y) {}

    /** Draws over the bodies what they do not show by themselves. */
    default void sketch(Pool pool, Sketch sketch) {}

    /** What to look at. */
    default View view() {
        return new View(0, 4, 10);
    }

    /** A pool with the bodies in it. */
    default Pool open() {
        Pool pool = new Pool(effects(), Accuracy.GAME);
        build(pool);
        return pool;
    }

    /** Lets a pool of this exhibit run so many seconds. */
    default void run(Pool pool, double seconds) {
        long steps = Math.round(seconds / Scene.STEP);
        for (long i = 0; i < steps; i++) {
            beforeStep(pool);
            pool.step(Scene.STEP);
        }
    }
}
