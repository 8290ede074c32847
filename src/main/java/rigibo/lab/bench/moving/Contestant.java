package rigibo.lab.bench.moving;

import rigibo.lab.bench.Inquiry;
import rigibo.lab.bench.probe.Stage;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;

import java.util.List;
import java.util.stream.Stream;

/**
 * An engine at one of its settings.
 *
 * @param engine name
 * @param setting name of one of its settings
 */
public record Contestant(String engine, String setting) {

    /** The names of our presets, the fastest first. */
    public static final List<String> PRESETS = List.of("DRAFT", "GAME", "FINE", "EXACT");

    /** Our engine at the game's preset. */
    static final Contestant OURS = new Contestant(RigiBoEngine.NAME, "GAME");

    private static final String BOX2D = "gdx-box2d";

    /**
     * The speed in m/s below which a body counts as still, in our engine and in those that never
     * quite come to rest.
     */
    private static final double STILL = 0.01;

    private static final double NEARLY_STILL = 0.05;

    /** Our engine at some presets; another engine at its default setting. */
    public static Stream<Contestant> of(Engine engine, List<String> presets) {
        Setting first = engine.settings().get(0);
        return first.line() == Line.PEERS
                ? Stream.of(new Contestant(engine.name(), first.name()))
                : presets.stream().map(preset -> new Contestant(engine.name(), preset));
    }

    Stage stage(Scene scene) {
        Engine asked = Engines.named(engine);
        return new Stage(asked, Engines.setting(asked, setting), scene);
    }

    /** Whether this is our engine. */
    public boolean isOurs() {
        return engine.equals(RigiBoEngine.NAME);
    }

    /** Whether this is the fastest engine that a Java programmer could choose. */
    public boolean isFastestPeer() {
        return Inquiry.shortName(engine).equals(BOX2D);
    }

    double still() {
        return isOurs() ? STILL : NEARLY_STILL;
    }

    /** The name in a table. */
    String words() {
        return isOurs() ? engine + " " + setting : engine;
    }
}
