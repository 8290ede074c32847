package rigibo.frontend.scene.trial;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;

/**
 * The subject of a measurement; if any of these changes, earlier results are void.
 *
 * @param pool the scene's
 * @param effects the declared effects
 * @param accuracy of the pool
 */
public record Subject(Pool pool, Effects effects, Accuracy accuracy) {

    /** The present state of a pool. */
    public static Subject of(Pool pool) {
        return new Subject(pool, pool.effects(), pool.accuracy());
    }
}
