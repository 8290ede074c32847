package rigibo.frontend.puzzle.hud;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import static rigibo.frontend.scene.Pointing.touch;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.frontend.puzzle.Levels;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.Pinch;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.RecordingNarrator;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Tap;
import rigibo.frontend.scene.widget.Plate;

import java.util.List;

/** A level in a handheld window, used by its buttons. */
class InHandTest {

    private static final int LONGEST = 60 * 60;
    private static final double ROUND_OFF = 1e-9;

    private final RecordingDirector director = new RecordingDirector();
    private final Scene scene = Levels.entries().get(1).open().apply(director);

    static List<Layout> hands() {
        return Legibility.HANDS;
    }

    @ParameterizedTest
    @MethodSource("hands")
    void theButtonsPauseAndLeadOut(Layout layout) {
        touch(scene, layout, "Pause");
        assertThat(RecordingCanvas.of(scene, layout).texts()).contains("Resume");
        touch(scene, layout, "Resume");
        assertThat(RecordingCanvas.of(scene, layout).texts()).contains("Pause");
        touch(scene, layout, "Levels");
        touch(scene, layout, "Menu");
        assertThat(director.asked).containsExactly("levels", "menu");
    }

    @ParameterizedTest
    @MethodSource("hands")
    void theEndCanBeReadAndLeadsToTheNextLevel(Layout layout) {
        for (String language : Settings.LANGUAGES) {
            director.settings(director.settings().withLanguage(language));
            Scene level = Levels.entries().get(0).open().apply(director);
            Demonstration show = level.demonstration().orElseThrow();
            for (int turn = 0; turn < LONGEST && !show.isOver(); turn++) {
                RecordingCanvas canvas = RecordingCanvas.of(level, layout);
                show.pointer().ifPresent(at -> level.pointerMoved(at.x(), at.y()));
                show.key().ifPresent(level::keyPressed);
                show.click()
                        .ifPresent(at -> level.pointerPressed(PointerButton.LEFT, at.x(), at.y()));
                level.step();
                if (show.picture().isPresent() && !canvas.texts().isEmpty()) {
                    assertThat(Legibility.faults(level, layout)).isEmpty();
                }
            }
            assertThat(show.hasSucceeded()).isTrue();
            assertThat(Legibility.faults(level, layout)).isEmpty();
        }
    }

    /** A thumb, or a mouse in a full screen, hits the edge without looking. */
    @Test
    void theLowerEdgeOfTheWindowBelongsToTheButtonsAboveIt() {
        press(Layout.ALONE, "Pause");
        assertThat(RecordingCanvas.of(scene).texts()).contains("Resume");
        press(Legibility.HANDS.get(0), "Menu");
        assertThat(director.asked).containsExactly("menu");
    }

    /** Presses below a button, at the window's lower edge. */
    private void press(Layout layout, String words) {
        double[] at = RecordingCanvas.of(scene, layout).middleOf(words);
        scene.pointerPressed(PointerButton.LEFT, at[0], layout.bottom());
    }

    /** The pillars of the first level are narrower than a finger. */
    @ParameterizedTest
    @MethodSource("hands")
    void aFingerOnSmallBoxesSeesThemMagnified(Layout layout) {
        Scene level = Levels.entries().get(0).open().apply(director);
        double[] pillar = RecordingCanvas.of(level, layout).bodies().get(1);
        level.pointerMoved(pillar[0], pillar[1]);
        assertThat(level.tap(pillar[0], pillar[1])).isEqualTo(Tap.CHOSEN);
        int before = RecordingCanvas.of(level, layout).lines().size();
        level.choosing(true);
        RecordingCanvas lens = RecordingCanvas.of(level, layout);
        assertThat(lens.lines().size()).isGreaterThan(before + 8);
        assertThat(lens.isUnderPanel(pillar[0], pillar[1])).as("beside the finger").isFalse();
        level.choosing(false);
        assertThat(RecordingCanvas.of(level, layout).lines()).hasSize(before);
    }

    /** An enlarged box is clicked at its place on the screen and needs no lens. */
    @ParameterizedTest
    @MethodSource("hands")
    void twoFingersEnlargeABoxAndOneClicksIt(Layout layout) {
        Scene level = Levels.entries().get(0).open().apply(director);
        List<Control> before = boxes(level, layout);
        double x = middleX(before.get(0));
        double y = middleY(before.get(0));
        level.pinched(new Pinch(5, x, y, 0, 0));
        level.pinched(new Pinch(1, x + 20, y + 10, 20, 10));
        Control box = boxes(level, layout).get(0);
        assertThat(middleX(box)).isCloseTo(x + 20, within(ROUND_OFF));
        assertThat(middleY(box)).isCloseTo(y + 10, within(ROUND_OFF));
        assertThat(Legibility.faults(level, layout)).isEmpty();
        assertThat(Legibility.tooSmallForFingers(level, layout)).isEmpty();
        level.pointerMoved(middleX(box), middleY(box));
        int lines = RecordingCanvas.of(level, layout).lines().size();
        level.choosing(true);
        assertThat(RecordingCanvas.of(level, layout).lines()).hasSize(lines);
        level.choosing(false);

        level.pointerPressed(PointerButton.LEFT, middleX(box), middleY(box));
        level.pointerReleased(PointerButton.LEFT, middleX(box), middleY(box));
        double[] whole = RecordingCanvas.of(level, layout).middleOf("See all of it");
        assertThat(level.tap(whole[0], whole[1])).isEqualTo(Tap.LIFTED);
        level.pointerPressed(PointerButton.LEFT, whole[0], whole[1]);

        List<Control> after = boxes(level, layout);
        assertThat(after).hasSize(before.size() - 1);
        assertThat(middleX(after.get(0))).isEqualTo(middleX(before.get(1)));
        assertThat(RecordingCanvas.of(level, layout).texts()).doesNotContain("See all of it");
    }

    private static List<Control> boxes(Scene level, Layout layout) {
        RecordingCanvas.of(level, layout);
        return RecordingNarrator.of(level).controls().stream()
                .filter(control -> control.name().startsWith("RigiBo"))
                .toList();
    }

    private static double middleX(Control control) {
        return control.x() + control.width() / 2;
    }

    private static double middleY(Control control) {
        return control.y() + control.height() / 2;
    }

    @ParameterizedTest
    @MethodSource("hands")
    void buttonsAreAsLargeAsAFinger(Layout layout) {
        Plate button = HandPlaces.of(layout, 8).keys().first();
        assertThat(Math.min(button.width(), button.height()) * layout.ratio())
                .isGreaterThanOrEqualTo(44 - ROUND_OFF);
    }
}
