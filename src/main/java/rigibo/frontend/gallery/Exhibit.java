package rigibo.frontend.gallery;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Scene;

import java.util.Locale;

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

    /** Name of an exhibit's class in the form of the command line, such as {@code card-house}. */
    static String name(Class<? extends Exhibit> type) {
        return type.getSimpleName()
                .replaceAll("(?<=[a-z0-9])(?=[A-Z])", "-")
                .toLowerCase(Locale.ROOT);
    }

    /** The effects that the scene declares. */
    default Effects effects() {
        return Effects.usual();
    }

    /** Adds the bodies to an empty pool. */
    void build(Pool pool);

    /** Called before each step; the results of the last step can be read here. */
    default void beforeStep(Pool pool) {}

    /** Handles a press of the right button at a point of the world, m. */
    default void act(Pool pool, double x, double y) {}

    /** Draws over the bodies whatever they do not show by themselves. */
    default void sketch(Pool pool, Sketch sketch) {}

    /** The initial view. */
    default View view() {
        return new View(0, 4, 10);
    }

    /** Makes a pool with the bodies in it. */
    default Pool open() {
        Pool pool = new Pool(effects(), Accuracy.GAME);
        build(pool);
        return pool;
    }

    /** Runs a pool of this exhibit for some seconds. */
    default void run(Pool pool, double seconds) {
        long steps = Math.round(seconds / Scene.STEP);
        for (long i = 0; i < steps; i++) {
            beforeStep(pool);
            pool.step(Scene.STEP);
        }
    }
}
