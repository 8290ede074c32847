package rigibo.lab.engine;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Our engine, at its presets and with each knob varied alone from the game's preset. */
public final class RigiBoEngine implements Engine {

    /** The engine's name in reports. */
    public static final String NAME = "RigiBo";

    private final Map<Setting, Accuracy> choices = new LinkedHashMap<>();

    /** Lays out every setting. */
    public RigiBoEngine() {
        new Sweeps(choices::put).all();
    }

    @Override
    public String name() {
        return NAME;
    }

    @Override
    public List<Setting> settings() {
        return List.copyOf(choices.keySet());
    }

    /** The first setting with equal knobs and an equal step. */
    @Override
    public Setting standsFor(Setting setting) {
        return choices.keySet().stream()
                .filter(first -> first.step() == setting.step())
                .filter(first -> choices.get(first).equals(choices.get(setting)))
                .findFirst()
                .orElseThrow();
    }

    @Override
    public World world(Effects effects, Setting setting) {
        return world(effects, choices.get(setting));
    }

    /** A world at any accuracy, for reference solutions. */
    public static World world(Effects effects, Accuracy accuracy) {
        return new RigiBoWorld(new Pool(effects, accuracy));
    }

    /** A world around an existing pool and its bodies. */
    public static World world(Pool pool) {
        return new RigiBoWorld(pool);
    }
}
