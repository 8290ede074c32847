package rigibo.lab.engine;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.setup.Accuracy;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Ours, at its presets and with each knob turned alone from where the game has it. */
public final class RigiBoEngine implements Engine {

    /** As the reports call it. */
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

    /** The first that turns its knobs the same way and makes the same step. */
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

    /** A world at an accuracy that need not be a setting: for references. */
    public static World world(Effects effects, Accuracy accuracy) {
        return new RigiBoWorld(new Pool(effects, accuracy));
    }

    /** A world that is somebody's pool, with the bodies that are in it now. */
    public static World world(Pool pool) {
        return new RigiBoWorld(pool);
    }
}
