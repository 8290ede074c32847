package rigibo.frontend.puzzle.hud;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.scene.Pointing.click;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

import rigibo.backend.effect.Effect;
import rigibo.frontend.puzzle.Levels;
import rigibo.frontend.puzzle.PuzzleScene;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.SceneEntry;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.stream.Stream;

/** The effects bar in a level: a win under other effects than the level's own earns no prize. */
class PuzzleExperimentTest {

    private static final String NOT_COUNTED = "an experiment: does not count";

    /** Turns in which the click at 1 s, the fall and the hold of 3 s are over. */
    private static final int LONG_ENOUGH = 8 * 60;

    private final RecordingDirector director = new RecordingDirector();
    private final Level level = LevelTexts.sound();
    private final Scene scene = new PuzzleScene(director, List.of(level, level), 0);

    static Stream<SceneEntry> levels() {
        return Levels.entries().stream();
    }

    private static List<String> texts(Scene scene) {
        return RecordingCanvas.of(scene).texts();
    }

    /** Deletes the box below the ball by keys, and waits. */
    private void solve() {
        scene.keyPressed(Key.TAB);
        scene.keyPressed(Key.ENTER);
        for (int i = 0; i < LONG_ENOUGH; i++) {
            scene.step();
        }
        scene.pointerMoved(-1, -1);
        assertThat(texts(scene)).contains("Solved!");
    }

    @ParameterizedTest
    @MethodSource("levels")
    void isShutUntilItIsAskedForAndThenCoversNothingThatTheLevelShows(SceneEntry entry) {
        Scene shut = entry.open().apply(director);
        assertThat(texts(shut)).contains("Effects").doesNotContain("gravity");
        shut.keyPressed(Key.E);
        RecordingCanvas open = RecordingCanvas.of(shut);
        assertThat(open.texts()).contains("gravity");
        assertBodiesAreSeen(shut, Layout.ALONE.withText(1.3, 1.3));
        assertBodiesAreSeen(shut, Layout.ALONE);
        assertThat(Legibility.faults(shut)).isEmpty();
        shut.keyPressed(Key.E);
        assertThat(texts(shut)).doesNotContain("gravity");
    }

    private static void assertBodiesAreSeen(Scene scene, Layout layout) {
        RecordingCanvas canvas = RecordingCanvas.of(scene, layout);
        double foot = EffectsDrawer.foot(layout);
        assertThat(canvas.bodies()).allSatisfy(body -> assertThat(body[1]).isGreaterThan(foot));
    }

    @Test
    void litIsWhatTheLevelDeclares() {
        scene.keyPressed(Key.E);
        RecordingCanvas canvas = RecordingCanvas.of(scene);
        Words words = new Words("en");
        for (Effect effect : level.world().effects().all()) {
            String name = words.of("effect." + effect.title());
            assertThat(canvas.plateOf(name)).isEqualTo(Color.BRASS);
        }
        assertThat(canvas.plateOf("wind")).isEqualTo(Color.PANEL_LIT);
    }

    @Test
    void aLevelThatIsSolvedAsItIsMeantEarnsItsMedal() {
        solve();
        assertThat(texts(scene)).contains("gold: 1 click").doesNotContain(NOT_COUNTED);
        scene.keyPressed(Key.ENTER);
        assertThat(director.shown).hasSize(1);
    }

    @Test
    void aLevelThatIsSolvedInAnExperimentEarnsNothingAndSaysSo() {
        scene.keyPressed(Key.E);
        click(scene, "sleep");
        scene.keyPressed(Key.E);
        solve();
        assertThat(texts(scene))
                .contains(NOT_COUNTED, "experiment")
                .noneMatch(words -> words.startsWith("gold"));
        assertThat(Legibility.faults(scene)).isEmpty();
        scene.keyPressed(Key.E);
        assertThat(texts(scene)).contains(NOT_COUNTED);
        assertThat(Legibility.faults(scene)).as("with the bar open").isEmpty();
        scene.keyPressed(Key.ENTER);
        assertThat(director.shown).as("there is no way on").isEmpty();
        assertThat(director.progress()).isEqualTo(Progress.none());
    }

    /** The consequences remain, so the try does not count after the effect is off again. */
    @Test
    void anExperimentStaysOneWhenTheEffectIsSwitchedBack() {
        scene.keyPressed(Key.E);
        click(scene, "sleep");
        click(scene, "sleep");
        scene.keyPressed(Key.E);
        solve();
        assertThat(texts(scene)).contains(NOT_COUNTED);
    }

    @Test
    void restartEndsTheExperiment() {
        scene.keyPressed(Key.E);
        click(scene, "gravity");
        assertThat(RecordingCanvas.of(scene).plateOf("gravity")).isEqualTo(Color.PANEL_LIT);
        scene.keyPressed(Key.R);
        assertThat(RecordingCanvas.of(scene).plateOf("gravity")).isEqualTo(Color.BRASS);
        scene.keyPressed(Key.E);
        solve();
        assertThat(texts(scene)).contains("gold: 1 click");
    }

    @Test
    void aClickOnTheBarDeletesNothing() {
        scene.keyPressed(Key.E);
        for (int x = 0; x < Scene.WIDTH; x += 10) {
            scene.pointerPressed(PointerButton.LEFT, x, EffectsDrawer.foot(Layout.ALONE) - 20);
        }
        assertThat(texts(scene)).anyMatch(words -> words.startsWith("0 clicks"));
    }
}
