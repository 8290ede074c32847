package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Settings;

import java.util.List;
import java.util.stream.Stream;

/** All texts of a demo can be read. */
class DemoLegibilityTest {

    private static final int SECOND = 60;

    /** The usual window, the smallest, and those with one column and two, with larger text, too. */
    private static final List<Layout> LAYOUTS =
            Stream.of(
                            Layout.of(612, 680, 1),
                            Layout.of(1024, 768, 1),
                            Layout.of(1000, 800, 1),
                            Layout.of(1000, 680, 1),
                            Layout.of(1280, 800, 1),
                            Layout.of(1366, 680, 1),
                            Layout.of(1920, 1080, 1),
                            Layout.of(612, 680, 1).withText(1.3, 1.3),
                            Layout.of(1024, 768, 1).withText(1.3, 1.3),
                            Layout.of(1366, 768, 1).withText(1.15, 1.3),
                            Layout.of(1366, 768, 1).withText(1.3, 1.3),
                            Layout.of(1920, 1080, 1).withText(1.3, 1.3),
                            Layout.ALONE.withText(1.3, 1.3),
                            Layout.ALONE)
                    .map(Layout::withColumns)
                    .toList();

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
        scene.closed();
    }

    @ParameterizedTest
    @MethodSource("demos")
    void isLegibleWithHelpDebuggingAndPaused(SceneEntry demo, String language) {
        for (Key key : new Key[] {Key.F1, Key.D, Key.SPACE, Key.C, Key.E, Key.N, Key.G, Key.T}) {
            Scene scene = open(demo, language);
            run(scene, SECOND);
            scene.keyPressed(key);
            run(scene, 2);
            assertLegible(scene);
            scene.closed();
        }
    }

    /** F1 helps whoever plays; what the engine does is on a page of its own, and Esc leads back. */
    @ParameterizedTest
    @MethodSource("demos")
    void helpAndTheStagesOfAStepAreTwoPages(SceneEntry demo, String language) {
        Scene scene = open(demo, language);
        run(scene, 2);
        String stage = language.equals("de") ? "VORAUSWAHL" : "BROADPHASE";
        assertThat(shown(scene)).doesNotContain("F1");
        scene.keyPressed(Key.F1);
        assertThat(shown(scene)).contains("F1").doesNotContain(stage);
        scene.keyPressed(Key.F1);
        assertLegible(scene);
        assertThat(shown(scene)).contains(stage);
        assertThat(scene.escaped()).as("back to the demo").isTrue();
        assertThat(shown(scene)).doesNotContain(stage);
        assertThat(scene.escaped()).as("to the menu").isFalse();
        scene.closed();
    }

    private static String shown(Scene scene) {
        return String.join("\n", RecordingCanvas.of(scene).texts());
    }

    /** What is told of the dial, of the numbers beside or below it, and of each effect. */
    @ParameterizedTest
    @MethodSource("demos")
    void isLegibleWhateverIsPointedAt(SceneEntry demo, String language) {
        Scene scene = open(demo, language);
        run(scene, 2);
        for (Layout layout : LAYOUTS) {
            RecordingCanvas canvas = RecordingCanvas.of(scene, layout);
            for (String words : canvas.texts()) {
                double[] at = canvas.firstMiddleOf(words);
                scene.pointerMoved(at[0], at[1]);
                assertThat(Legibility.faults(scene, layout))
                        .as("%s in %s at %s", scene.title(), layout, words)
                        .isEmpty();
            }
        }
        scene.closed();
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
        for (Layout layout : LAYOUTS) {
            assertThat(Legibility.faults(scene, layout)).as(scene.title() + layout).isEmpty();
        }
    }
}
