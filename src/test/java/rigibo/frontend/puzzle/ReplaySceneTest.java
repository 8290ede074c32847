package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.Recordings;
import rigibo.frontend.puzzle.rules.Checkpoint;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Words;

import java.util.ArrayList;
import java.util.List;

class ReplaySceneTest {

    private static final String SAME = "the same to the last bit";

    private final Recording recording = Recordings.sound();

    private static void turn(ReplayScene scene, int turns) {
        for (int i = 0; i < turns; i++) {
            scene.step();
        }
    }

    private static String seen(ReplayScene scene) {
        return String.join("\n", RecordingCanvas.of(scene).texts());
    }

    private ReplayScene scene() {
        return scene("en", recording);
    }

    private static ReplayScene scene(String language, Recording shown) {
        return new ReplayScene(new RecordingDirector(language), shown, ReplayScene.Audience.PLAYER);
    }

    @Test
    void theVerdictComesAtTheEndAndStays() {
        ReplayScene scene = scene();
        turn(scene, recording.steps() - 1);
        assertThat(seen(scene)).doesNotContain(SAME);
        turn(scene, 1);
        assertThat(seen(scene)).contains(SAME);
        turn(scene, 600);
        assertThat(seen(scene)).contains(SAME);
    }

    @Test
    void pausesAndStepsOnce() {
        ReplayScene scene = scene();
        turn(scene, recording.steps() - 1);
        scene.keyPressed(Key.SPACE);
        turn(scene, 100);
        assertThat(seen(scene)).contains("paused").doesNotContain(SAME);
        scene.keyPressed(Key.PERIOD);
        assertThat(seen(scene)).contains("paused", SAME);
    }

    @ParameterizedTest
    @CsvSource({"RIGHT, 2", "LEFT, -2"})
    void aSpeedIsInWholeSteps(Key key, int factor) {
        ReplayScene scene = scene();
        scene.keyPressed(key);
        int turns =
                factor > 0
                        ? (recording.steps() + factor - 1) / factor
                        : recording.steps() * -factor;
        turn(scene, turns - 2);
        assertThat(seen(scene)).doesNotContain(SAME);
        turn(scene, 2);
        assertThat(seen(scene)).contains(SAME);
    }

    @Test
    void playsFromTheStart() {
        ReplayScene scene = scene();
        turn(scene, recording.steps() + 10);
        scene.keyPressed(Key.R);
        assertThat(seen(scene)).contains("0 clicks").doesNotContain(SAME);
        turn(scene, recording.steps());
        assertThat(seen(scene)).contains(SAME);
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void canBeReadInEveryState(String language) {
        List<Checkpoint> changed = new ArrayList<>(recording.checkpoints());
        changed.set(3, new Checkpoint(changed.get(3).step(), 1));
        Recording other = new Recording(recording.level(), recording.replay(), changed);
        for (Recording one : List.of(recording, other)) {
            ReplayScene scene = scene(language, one);
            assertThat(Legibility.faults(scene)).isEmpty();
            assertThat(Legibility.faultsInHand(scene)).isEmpty();
            turn(scene, 100);
            scene.keyPressed(Key.SPACE);
            assertThat(Legibility.faults(scene)).isEmpty();
            assertThat(Legibility.faultsInHand(scene)).isEmpty();
            scene.keyPressed(Key.SPACE);
            scene.keyPressed(Key.LEFT);
            turn(scene, 2 * recording.steps());
            assertThat(Legibility.faults(scene)).isEmpty();
            assertThat(Legibility.faultsInHand(scene)).isEmpty();
            assertThat(scene.title())
                    .contains(LevelTexts.sound().title().in(new Words(language).locale()));
        }
    }
}
