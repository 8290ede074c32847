package rigibo.frontend.demo;

import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Words;

import java.util.function.Function;
import java.util.stream.Stream;

/** The demos, for tests that ask all of them. */
final class EveryDemo {

    /** A window in which all plates stand beside the scene. */
    static final Layout WIDE = Layout.of(1920, 1080, 1).withColumns();

    private EveryDemo() {}

    /** Makes each of them. */
    static Stream<Function<Words, Demo>> all() {
        return Stream.of(
                CrateDemo::new,
                WheelDemo::new,
                FrictionDemo::new,
                FloodDemo::new,
                PendulumDemo::new,
                CarDemo::new);
    }

    /** Puts the bodies of a demo on a bench. */
    static Workbench built(Demo demo) {
        Workbench bench = new Workbench(demo.effects(), demo.camera());
        demo.build(bench);
        return bench;
    }
}
