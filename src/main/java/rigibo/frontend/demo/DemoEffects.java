package rigibo.frontend.demo;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effect;
import rigibo.backend.effect.Effects;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.effects.EffectReason;
import rigibo.frontend.scene.effects.SceneEffects;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** The effects bar's view of a demo on its workbench. */
final class DemoEffects implements SceneEffects {

    private final Demo demo;
    private final Workbench bench;
    private final Words words;

    DemoEffects(Demo demo, Workbench bench, Words words) {
        this.demo = demo;
        this.bench = bench;
        this.words = words;
    }

    @Override
    public Words words() {
        return words;
    }

    @Override
    public Pool pool() {
        return bench.pool();
    }

    @Override
    public Effects calledFor() {
        return demo.effects();
    }

    @Override
    public List<EffectReason> reasons() {
        return demo.reasons();
    }

    @Override
    public void experiment(Effects effects) {
        bench.pool().effects(effects);
    }

    @Override
    public String marking() {
        return kinds(pool().effects()).equals(kinds(calledFor()))
                ? ""
                : words.of("demo.experiment");
    }

    private static Set<Class<?>> kinds(Effects effects) {
        return effects.all().stream().map(Effect::getClass).collect(Collectors.toSet());
    }
}
