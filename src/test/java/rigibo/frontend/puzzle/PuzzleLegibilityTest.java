package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Action;
import rigibo.frontend.scene.Demonstration;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.KeyBindings;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Settings;

import java.util.List;
import java.util.stream.Stream;

/** All words of a level are legible in every language and cover none of the play. */
class PuzzleLegibilityTest {

    /** More than any stored solution takes, in turns of 1/60 s. */
    private static final int LONGEST = 60 * 60;

    /** A level in a language. */
    private record Case(SceneEntry level, String language) {

        Scene open(RecordingDirector director) {
            director.settings(director.settings().withLanguage(language));
            return level.open().apply(director);
        }

        @Override
        public String toString() {
            return level.name() + " in " + language;
        }
    }

    /**
     * Windows with room for columns: just enough room, just enough in a low window, and more than
     * enough.
     */
    private static final List<Layout> WIDE =
            List.of(
                    Layout.of(1280, 800, 1),
                    Layout.of(1366, 680, 1),
                    Layout.of(1366, 768, 1).withText(1.3, 1.3),
                    Layout.of(1920, 1080, 1));

    static Stream<Case> cases() {
        return Levels.entries().stream()
                .flatMap(
                        level ->
                                Settings.LANGUAGES.stream()
                                        .map(language -> new Case(level, language)));
    }

    @ParameterizedTest
    @MethodSource("cases")
    void fromTheStartToTheVictory(Case level) {
        Scene scene = level.open(new RecordingDirector());
        Demonstration show = scene.demonstration().orElseThrow();
        for (int turn = 0; turn < LONGEST && !show.isOver(); turn++) {
            show.pointer().ifPresent(at -> scene.pointerMoved(at.x(), at.y()));
            show.key().ifPresent(scene::keyPressed);
            show.click().ifPresent(at -> scene.pointerPressed(PointerButton.LEFT, at.x(), at.y()));
            scene.step();
            if (turn % 60 == 0) {
                assertLegible(scene);
            }
        }
        assertThat(show.hasSucceeded()).isTrue();
        scene.step();
        assertLegible(scene);
        scene.keyPressed(Key.LEFT);
        scene.keyPressed(Key.LEFT);
        scene.keyPressed(Key.ENTER);
        scene.step();
        assertLegible(scene);
    }

    @ParameterizedTest
    @MethodSource("cases")
    void inAHandItCanBeReadAndNothingCoversThePlay(Case level) {
        for (Layout layout : Legibility.HANDS) {
            Scene scene = level.open(new RecordingDirector());
            scene.keyPressed(Key.S);
            scene.step();
            assertThat(Legibility.faults(scene, layout)).as(level + " in " + layout).isEmpty();
            RecordingCanvas canvas = RecordingCanvas.of(scene, layout);
            assertThat(canvas.bodies())
                    .as(level + " in " + layout)
                    .noneMatch(body -> canvas.isUnderPanel(body[0], body[1]));
        }
    }

    @ParameterizedTest
    @MethodSource("cases")
    void pausedSlowedRefusedAndChosenByKeys(Case level) {
        Scene scene = level.open(new RecordingDirector());
        for (Key key : new Key[] {Key.S, Key.S, Key.P, Key.TAB, Key.P, Key.BACKSPACE, Key.H}) {
            scene.keyPressed(key);
            scene.step();
            assertLegible(scene);
            assertPlayIsUncovered(scene);
        }
        scene.pointerPressed(PointerButton.LEFT, 5, 100);
        assertLegible(scene);
        assertPlayIsUncovered(scene);
    }

    @ParameterizedTest
    @MethodSource("cases")
    void withItsHintAndItsSolution(Case level) {
        RecordingDirector director = new RecordingDirector();
        Scene scene = level.open(director);
        while (!RecordingCanvas.of(scene)
                .texts()
                .contains(director.words().of("puzzle.command.hint"))) {
            scene.keyPressed(Key.TAB);
            scene.keyPressed(Key.ENTER);
            scene.keyPressed(Key.R);
            scene.step();
        }
        assertLegible(scene);
        scene.keyPressed(Key.H);
        scene.step();
        assertLegible(scene);
        scene.keyPressed(Key.V);
        scene.step();
        assertLegible(scene);
        assertPlayIsUncovered(scene);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void withKeysOfLongNames(String language) {
        RecordingDirector director = new RecordingDirector(language);
        KeyBindings keys =
                director.settings()
                        .keys()
                        .with(Action.SOLUTION, Key.BACKSPACE)
                        .flatMap(chosen -> chosen.with(Action.RESTART, Key.SPACE))
                        .orElseThrow();
        director.settings(director.settings().withKeys(keys));
        Scene scene = Levels.entries().get(0).open().apply(director);
        for (int failures = 0; failures < 3; failures++) {
            scene.keyPressed(Key.TAB);
            scene.keyPressed(Key.ENTER);
            scene.keyPressed(Key.R);
            scene.step();
        }
        assertLegible(scene);
        for (Key key : new Key[] {Key.H, Key.E}) {
            scene.keyPressed(key);
            scene.step();
            assertLegible(scene);
        }
    }

    private static void assertLegible(Scene scene) {
        for (Layout wide : WIDE) {
            assertThat(Legibility.faults(scene, wide)).as(scene.title() + wide).isEmpty();
        }
        assertThat(Legibility.faults(scene)).as(scene.title()).isEmpty();
    }

    private static void assertPlayIsUncovered(Scene scene) {
        RecordingCanvas canvas = RecordingCanvas.of(scene);
        for (double y = View.BAR_FOOT + 1; y < View.KEYS_TOP; y += 4) {
            assertThat(canvas.isUnderPanel(Scene.WIDTH / 2.0, y)).as("at %s", y).isFalse();
        }
    }
}
