package rigibo.peers;

import rigibo.backend.effect.Effects;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;

import java.util.stream.Stream;

/** Another engine at one of its settings. */
record Peer(Engine engine, Setting setting) {

    /** All that are at hand: none where the class path does not hold them. */
    static Stream<Peer> all() {
        return engines()
                .flatMap(engine -> engine.settings().stream().map(each -> new Peer(engine, each)));
    }

    static Stream<Engine> engines() {
        return Engines.all().stream().filter(engine -> !(engine instanceof RigiBoEngine));
    }

    World world(Effects effects) {
        return engine.world(effects, setting);
    }

    double step() {
        return setting.step();
    }

    /** Into how many it divides a step: the engines of Rust, four unless a setting says more. */
    int substeps() {
        String digits = setting.name().replaceAll("\\D", "");
        if (!digits.isEmpty()) {
            return Integer.parseInt(digits);
        }
        boolean isSubstepped =
                engine.name().startsWith("Box2D") || engine.name().startsWith("Rapier");
        if (!isSubstepped) {
            return 1;
        }
        return setting.step() < Setting.USUAL_STEP ? 16 : 4;
    }

    /** Goes on by so many seconds; returns the number of steps. */
    int run(World world, double seconds) {
        int steps = (int) Math.round(seconds / step());
        for (int i = 0; i < steps; i++) {
            world.step(step());
        }
        return steps;
    }

    @Override
    public String toString() {
        return engine.name() + ", " + setting.name();
    }
}
