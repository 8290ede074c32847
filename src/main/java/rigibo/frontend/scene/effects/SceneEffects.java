package rigibo.frontend.scene.effects;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.frontend.scene.Words;

import java.util.List;

/** The effects bar's view of a scene. */
public interface SceneEffects {

    /** The player's. */
    Words words();

    /** The pool that is simulated now; a restarted scene may return another one. */
    Pool pool();

    /** The effects that the scene calls for. */
    Effects calledFor();

    /** The scene's own words about effects; for other effects general words are shown. */
    List<EffectReason> reasons();

    /** Simulates another set, as an experiment. */
    void experiment(Effects effects);

    /** How an experiment is marked in words; empty while there is none. */
    String marking();
}
