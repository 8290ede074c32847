package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.scene.Pointing.touch;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.RecordingNarrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Tap;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.function.Function;
import java.util.stream.Stream;

/** Demos in a handheld window, used by their buttons. */
class DemoInHandTest {

    /** Distance between the points that are tested for a plate, px. */
    private static final int PITCH = 8;

    static Stream<Arguments> demos() {
        return DemoLegibilityTest.demos();
    }

    @ParameterizedTest
    @MethodSource("demos")
    void everyPlateCanBeReadAndTouched(SceneEntry demo, String language) {
        Words words = new Words(language);
        for (Layout layout : Legibility.HANDS) {
            Scene scene = demo.open().apply(new RecordingDirector(language));
            scene.step();
            assertInOrder(scene, layout);
            List<String> signs = signs(RecordingCanvas.of(scene, layout));
            for (Fold fold : Fold.values()) {
                touch(scene, layout, words.of(fold.key()));
                scene.step();
                assertSaysWhatIsPointedAt(scene, layout, signs);
            }
            scene.closed();
        }
    }

    @ParameterizedTest
    @MethodSource("demos")
    void whatHasAnAddressIsSharedByAButton(SceneEntry demo, String language) {
        RecordingDirector director = new RecordingDirector(language);
        director.hasAddress = true;
        for (Layout layout : Legibility.HANDS) {
            director.asked.clear();
            Scene scene = demo.open().apply(director);
            assertThat(Legibility.faults(scene, layout)).isEmpty();
            assertThat(Legibility.tooSmallForFingers(scene, layout)).isEmpty();
            touch(scene, layout, director.words().of("hand.link"));
            assertThat(director.asked).containsExactly("share");
            scene.closed();
        }
    }

    /** On a desk, plates lie where an upright window in a hand would be empty. */
    @Test
    void lanesBeginAtTheLeftEdgeOfAnUprightWindow() {
        Scene scene = FrictionDemo.entry().open().apply(new RecordingDirector("en"));
        double upright = middleOfSign(scene, Legibility.HANDS.get(1));
        assertThat(upright).isLessThan(Scene.WIDTH / 4.0);
        for (Layout other : List.of(Layout.ALONE, Legibility.HANDS.get(3))) {
            assertThat(middleOfSign(scene, other)).isGreaterThan(upright + Scene.WIDTH / 5.0);
        }
        scene.closed();
    }

    private static double middleOfSign(Scene scene, Layout layout) {
        return RecordingCanvas.of(scene, layout).firstMiddleOf("ice holds")[0];
    }

    private static void assertInOrder(Scene scene, Layout layout) {
        assertInOrder(scene, layout, List.of());
    }

    /** Whether all is in order, but for signs in the scene, which an open plate may cover. */
    private static void assertInOrder(Scene scene, Layout layout, List<String> signs) {
        assertThat(Legibility.faults(scene, layout))
                .as(scene.title() + " in " + layout)
                .allMatch(
                        fault -> signs.stream().anyMatch(sign -> fault.contains('"' + sign + '"')));
        assertThat(Legibility.tooSmallForFingers(scene, layout))
                .as(scene.title() + " in " + layout)
                .isEmpty();
    }

    /** The texts written into the scene. */
    private static List<String> signs(RecordingCanvas canvas) {
        return canvas.texts().stream().filter(text -> isInScene(canvas, text)).toList();
    }

    private static boolean isInScene(RecordingCanvas canvas, String text) {
        double[] at = canvas.firstMiddleOf(text);
        return at[0] > 0 && at[0] < Scene.WIDTH && at[1] > 0 && at[1] < Scene.HEIGHT;
    }

    private static void assertSaysWhatIsPointedAt(Scene scene, Layout layout, List<String> signs) {
        RecordingCanvas canvas = RecordingCanvas.of(scene, layout);
        for (String words : canvas.texts()) {
            double[] at = canvas.firstMiddleOf(words);
            scene.pointerMoved(at[0], at[1]);
            assertInOrder(scene, layout, signs);
        }
        scene.pointerMoved(-1000, -1000);
    }

    @Test
    void buttonsLeadOutAndPause() {
        for (Layout layout : Legibility.HANDS) {
            RecordingDirector director = new RecordingDirector();
            Scene scene = Demos.entries().get(0).open().apply(director);
            touch(scene, layout, "›");
            assertThat(director.shown).hasSize(1);
            touch(scene, layout, "Menu");
            assertThat(director.asked).containsExactly("menu");
            touch(scene, layout, "accuracy");
            touch(scene, layout, "Pause");
            assertThat(RecordingCanvas.of(scene, layout).texts())
                    .anyMatch(words -> words.contains("paused"));
            scene.closed();
        }
    }

    /** Phones have room around the scene for all that is there before a plate is opened. */
    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void nothingLiesOverTheSceneUntilItIsOpened(Function<Words, Demo> maker) {
        for (Layout layout : Legibility.HANDS) {
            RecordingDirector director = new RecordingDirector();
            Scene scene = new DemoScene(director, maker);
            RecordingCanvas canvas = RecordingCanvas.of(scene, layout);
            for (String word : List.of("Menu", "Restart", "controls", "ghost")) {
                assertThat(isInScene(canvas, word)).as(word + " in " + layout).isFalse();
            }
            int covered = 0;
            for (int x = PITCH / 2; x < Scene.WIDTH; x += PITCH) {
                covered += canvas.isUnderPanel(x, PITCH / 2) ? 1 : 0;
                covered += canvas.isUnderPanel(x, Scene.HEIGHT - PITCH / 2) ? 1 : 0;
            }
            assertThat(covered).as("at the edges in " + layout).isZero();
            scene.closed();
        }
    }

    @Test
    void fingersPressButtonsWhenTheyAreLiftedAndRailsAtOnce() {
        for (Layout layout : Legibility.HANDS) {
            Scene scene = Demos.entries().get(0).open().apply(new RecordingDirector());
            touch(scene, layout, "controls");
            RecordingCanvas canvas = RecordingCanvas.of(scene, layout);
            assertThat(tap(scene, canvas, "Menu")).isEqualTo(Tap.LIFTED);
            assertThat(tap(scene, canvas, "controls")).isEqualTo(Tap.LIFTED);
            assertThat(tap(scene, canvas, "pyramid")).isEqualTo(Tap.LIFTED);
            assertThat(tap(scene, canvas, "pyramid's rows")).isEqualTo(Tap.AT_ONCE);
            scene.closed();
        }
    }

    /** A player who does not see a demo uses its controls by name. */
    @Test
    void whatCanBeUsedHasANameWhereItIs() {
        for (Layout layout : Legibility.HANDS) {
            Scene scene = Demos.entries().get(0).open().apply(new RecordingDirector());
            RecordingCanvas.of(scene, layout);
            RecordingNarrator.press(scene, RecordingNarrator.of(scene).control("controls"));
            RecordingCanvas canvas = RecordingCanvas.of(scene, layout);
            RecordingNarrator told = RecordingNarrator.of(scene);
            assertThat(told.names()).contains("Menu", "The next one", "accuracy", "pyramid");
            Control rows =
                    told.controls().stream()
                            .filter(it -> it.name().startsWith("pyramid's rows: "))
                            .findFirst()
                            .orElseThrow();
            double[] label = canvas.firstMiddleOf("pyramid's rows");
            assertThat(rows.kind()).isEqualTo(Control.Kind.SLIDER);
            assertThat(label[1]).isBetween(rows.y(), rows.y() + rows.height());
            RecordingNarrator.press(scene, told.control("accuracy"));
            RecordingCanvas.of(scene, layout);
            assertThat(RecordingNarrator.of(scene).control("GAME").kind())
                    .isEqualTo(Control.Kind.ON);
            scene.closed();
        }
    }

    private static Tap tap(Scene scene, RecordingCanvas canvas, String words) {
        double[] at = canvas.firstMiddleOf(words);
        return scene.tap(at[0], at[1]);
    }
}
