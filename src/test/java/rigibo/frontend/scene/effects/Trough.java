package rigibo.frontend.scene.effects;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.scene.Words;

import java.util.List;

/** A scene that is nothing but its effects. */
final class Trough implements SceneEffects {

    static final String MARKING = "an experiment";

    private final Effects calledFor;
    private final List<EffectReason> reasons;
    private final Pool pool;

    Trough(Effects calledFor, EffectReason... reasons) {
        this.calledFor = calledFor;
        this.reasons = List.of(reasons);
        pool = new Pool(calledFor, Accuracy.GAME);
    }

    @Override
    public Words words() {
        return new Words("en");
    }

    @Override
    public Pool pool() {
        return pool;
    }

    @Override
    public Effects calledFor() {
        return calledFor;
    }

    @Override
    public List<EffectReason> reasons() {
        return reasons;
    }

    @Override
    public void experiment(Effects effects) {
        pool.effects(effects);
    }

    @Override
    public String marking() {
        return pool.effects().all().containsAll(calledFor.all())
                        && calledFor.all().containsAll(pool.effects().all())
                ? ""
                : MARKING;
    }
}
