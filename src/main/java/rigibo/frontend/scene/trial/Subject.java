package rigibo.frontend.scene.trial;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;

/**
 * What is measured; with any of these it is another matter and what was known is void.
 *
 * @param pool the scene's
 * @param effects it simulates
 * @param accuracy it runs at
 */
public record Subject(Pool pool, Effects effects, Accuracy accuracy) {

    /** A pool as it is now. */
    public static Subject of(Pool pool) {
        return new Subject(pool, pool.effects(), pool.accuracy());
    }
}
