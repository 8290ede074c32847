package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Settings;

import java.util.stream.Stream;

/** Whatever a demo shows can be read. */
class DemoLegibilityTest {

    private static final int SECOND = 60;

    static Stream<Arguments> demos() {
        return Demos.entries().stream()
                .flatMap(
                        demo ->
                                Settings.LANGUAGES.stream()
                                        .map(language -> Arguments.of(demo, language)));
    }

    @ParameterizedTest
    @MethodSource("demos")
    void isLegibleAtTheStart(SceneEntry demo, String language) {
        assertLegible(open(demo, language));
    }

    @ParameterizedTest
    @MethodSource("demos")
    void isLegibleAfterSomeSeconds(SceneEntry demo, String language) {
        Scene scene = open(demo, language);
        for (int second = 0; second < 5; second++) {
            run(scene, SECOND);
            assertLegible(scene);
        }
    }

    @ParameterizedTest
    @MethodSource("demos")
    void isLegibleWithHelpDebuggingAndPaused(SceneEntry demo, String language) {
        for (Key key : new Key[] {Key.F1, Key.D, Key.SPACE, Key.N, Key.G}) {
            Scene scene = open(demo, language);
            run(scene, SECOND);
            scene.keyPressed(key);
            run(scene, 2);
            assertLegible(scene);
        }
    }

    private static Scene open(SceneEntry demo, String language) {
        return demo.open().apply(new RecordingDirector(language));
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
