package rigibo.frontend.demo;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;

import java.util.function.Function;

/** Where the plates of demos are in windows of all shapes. */
class DemoPlatesTest {

    /** Distance between the points that are tested for a plate, px. */
    private static final int PITCH = 4;

    private static final Layout COLUMN = Layout.of(1024, 768, 1).withColumns();

    private static Scene open(Function<Words, Demo> maker) {
        return new DemoScene(new RecordingDirector(), maker);
    }

    /** Points of the scene that lie under panels. */
    private static int covered(Scene scene, Layout layout) {
        RecordingCanvas canvas = RecordingCanvas.of(scene, layout);
        int covered = 0;
        for (int x = PITCH / 2; x < Scene.WIDTH; x += PITCH) {
            for (int y = PITCH / 2; y < Scene.HEIGHT; y += PITCH) {
                covered += canvas.isUnderPanel(x, y) ? 1 : 0;
            }
        }
        return covered;
    }

    private static double share(Scene scene, Layout layout) {
        return covered(scene, layout) * PITCH * PITCH / (double) (Scene.WIDTH * Scene.HEIGHT);
    }

    private static void press(Scene scene, double x, double y) {
        scene.pointerPressed(PointerButton.LEFT, x, y);
        scene.pointerReleased(PointerButton.LEFT, x, y);
    }

    private static void click(Scene scene, Layout layout, String words) {
        double[] at = RecordingCanvas.of(scene, layout).middleOf(words);
        press(scene, at[0], at[1]);
        scene.pointerMoved(-1000, -1000);
    }

    /** Plates may cover a quarter; a plate that was opened may cover more. */
    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void coverAQuarterOfTheSceneAtMostUntilTheyAreOpened(Function<Words, Demo> maker) {
        Scene scene = open(maker);
        for (int second = 0; second < 3; second++) {
            assertThat(share(scene, Layout.ALONE)).isBetween(0.04, 0.25);
            for (int i = 0; i < 60; i++) {
                scene.step();
            }
        }
        scene.closed();
    }

    /** At the start no body's middle, and nothing that moves, is under a plate. */
    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void coverNoBody(Function<Words, Demo> maker) {
        Scene scene = open(maker);
        RecordingCanvas canvas = RecordingCanvas.of(scene);
        assertThat(canvas.bodies()).isNotEmpty();
        assertThat(canvas.bodies()).noneMatch(at -> canvas.isUnderPanel(at[0], at[1]));
        scene.closed();
    }

    /** Only things that the demo itself draws, such as flags, may still be covered. */
    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void coverNothingOfTheSceneInWideWindows(Function<Words, Demo> maker) {
        Scene scene = open(maker);
        for (Layout layout : new Layout[] {EveryDemo.WIDE, COLUMN}) {
            int shown = covered(scene, layout);
            scene.keyPressed(Key.T);
            assertThat(shown).isEqualTo(covered(scene, layout));
            scene.keyPressed(Key.T);
        }
        scene.closed();
    }

    /** On ice the box slides out of the scene, to where the plates of other demos are. */
    @Test
    void leaveTheLanesFreeToTheEdgeOfTheWindow() {
        Scene scene = open(FrictionDemo::new);
        RecordingCanvas canvas = RecordingCanvas.of(scene, EveryDemo.WIDE);
        for (double x = Scene.WIDTH; x < EveryDemo.WIDE.right(); x += PITCH) {
            for (double y = 0; y < Scene.HEIGHT; y += PITCH) {
                assertThat(canvas.isUnderPanel(x, y)).as("%s, %s", x, y).isFalse();
            }
        }
        scene.closed();
    }

    @ParameterizedTest
    @MethodSource("rigibo.frontend.demo.EveryDemo#all")
    void areHiddenAndShownByAKey(Function<Words, Demo> maker) {
        Scene scene = open(maker);
        for (Layout layout : new Layout[] {Layout.ALONE, COLUMN, EveryDemo.WIDE}) {
            assertThat(RecordingCanvas.of(scene, layout).texts()).contains("GAME", "frame");
            scene.keyPressed(Key.T);
            assertThat(RecordingCanvas.of(scene, layout).texts()).doesNotContain("GAME", "frame");
            scene.keyPressed(Key.T);
        }
        scene.closed();
    }

    /** Where plates would be, a click reaches the scene. */
    @Test
    void hiddenPlatesAreNotPressed() {
        Scene scene = open(CrateDemo::new);
        double[] exact = RecordingCanvas.of(scene).middleOf("EXACT");
        double[] controls = RecordingCanvas.of(scene).middleOf("controls");
        scene.keyPressed(Key.T);
        RecordingCanvas.of(scene);
        press(scene, exact[0], exact[1]);
        press(scene, controls[0], controls[1]);
        scene.keyPressed(Key.T);
        RecordingCanvas shown = RecordingCanvas.of(scene);
        assertThat(shown.plateOf("GAME")).isNotEqualTo(shown.plateOf("EXACT"));
        assertThat(shown.texts()).doesNotContain("pyramid");
        scene.closed();
    }

    @Test
    void areFoldedAndUnfoldedByTabsAndKeys() {
        Scene scene = open(CrateDemo::new);
        click(scene, Layout.ALONE, "controls");
        assertThat(RecordingCanvas.of(scene).texts()).contains("pyramid");
        click(scene, Layout.ALONE, "effects");
        assertThat(RecordingCanvas.of(scene).texts()).contains("pyramid", "gravity");
        scene.keyPressed(Key.C);
        scene.keyPressed(Key.E);
        assertThat(RecordingCanvas.of(scene).texts()).doesNotContain("pyramid", "gravity");
        click(scene, Layout.ALONE, "energy");
        assertThat(RecordingCanvas.of(scene).texts()).contains("potential");
        click(scene, Layout.ALONE, "energy");
        assertThat(RecordingCanvas.of(scene).texts()).doesNotContain("potential");
        scene.closed();
    }

    /** Controls, effects, frame, energy and ghost take turns in it. */
    @Test
    void oneOfThemIsOpenInAColumn() {
        Scene scene = open(CrateDemo::new);
        assertThat(RecordingCanvas.of(scene, COLUMN).texts()).contains("pyramid");
        click(scene, COLUMN, "effects");
        assertThat(RecordingCanvas.of(scene, COLUMN).texts())
                .contains("gravity")
                .doesNotContain("pyramid");
        click(scene, COLUMN, "ghost");
        assertThat(RecordingCanvas.of(scene, COLUMN).texts())
                .contains("from FINE")
                .doesNotContain("gravity");
        click(scene, COLUMN, "ghost");
        assertThat(RecordingCanvas.of(scene, COLUMN).texts()).contains("pyramid");
        scene.closed();
    }

    /** A click beside the scene reaches its plate, one in the scene the body that is seen there. */
    @Test
    void aClickReachesWhatIsSeenThere() {
        Scene scene = open(CrateDemo::new);
        for (Layout layout : new Layout[] {COLUMN, EveryDemo.WIDE}) {
            double[] pyramid = RecordingCanvas.of(scene, layout).middleOf("pyramid");
            assertThat(pyramid[0]).isNegative();
            int before = RecordingCanvas.of(scene, layout).bodies().size();
            press(scene, pyramid[0], pyramid[1]);
            assertThat(RecordingCanvas.of(scene, layout).bodies().size()).isGreaterThan(before);
            scene.keyPressed(Key.R);
        }
        RecordingCanvas canvas = RecordingCanvas.of(scene, EveryDemo.WIDE);
        double[] top = canvas.bodies().get(2);
        scene.pointerPressed(PointerButton.LEFT, top[0], top[1]);
        assertThat(RecordingCanvas.of(scene, EveryDemo.WIDE).moods()).contains(Canvas.Mood.HOVERED);
        scene.closed();
    }
}
