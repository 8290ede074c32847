package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;

import java.util.stream.Stream;

/** Whatever a demo shows can be read. */
class DemoLegibilityTest {

    private static final int SECOND = 60;

    static Stream<SceneEntry> demos() {
        return Demos.entries().stream();
    }

    @ParameterizedTest
    @MethodSource("demos")
    void isLegibleAtTheStart(SceneEntry demo) {
        assertLegible(open(demo));
    }

    @ParameterizedTest
    @MethodSource("demos")
    void isLegibleAfterSomeSeconds(SceneEntry demo) {
        Scene scene = open(demo);
        for (int second = 0; second < 5; second++) {
            run(scene, SECOND);
            assertLegible(scene);
        }
    }

    @ParameterizedTest
    @MethodSource("demos")
    void isLegibleWithHelpDebuggingAndPaused(SceneEntry demo) {
        for (Key key : new Key[] {Key.F1, Key.D, Key.SPACE}) {
            Scene scene = open(demo);
            run(scene, SECOND);
            scene.keyPressed(key);
            run(scene, 2);
            assertLegible(scene);
        }
    }

    private static Scene open(SceneEntry demo) {
        return demo.open().apply(new RecordingDirector());
    }

    private static void run(Scene scene, int turns) {
        for (int i = 0; i < turns; i++) {
            scene.step();
        }
    }

    private static void assertLegible(Scene scene) {
        assertThat(Legibility.faults(scene)).as(scene.title()).isEmpty();
    }
}
