package rigibo.frontend.puzzle.session;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.PlayedLevel;
import rigibo.frontend.puzzle.PuzzleScene;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Playback;
import rigibo.frontend.puzzle.rules.Replay;
import rigibo.frontend.scene.Canvas.Mood;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Scene;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** The player's best run beside the game is always at the same step. */
class GhostOfTheBestRunTest {

    @TempDir Path folder;

    private final Level level = PlayedLevel.twoBoxes();
    private final Replay replay =
            new Replay(level.hash(), List.of(new Act(60, "box")), Accuracy.GAME);
    private final RecordingDirector director = new RecordingDirector();

    private Recording run() {
        Playback playback = new Playback(level, replay);
        while (playback.game().outcome() == Outcome.RUNNING) {
            playback.step();
        }
        return Recording.of(playback.game());
    }

    /** The ghost is the recorded run at this step, to the last bit. */
    private void assertAt(BestRun ghost, int steps) {
        Playback again = new Playback(level, replay);
        again.stepTo(steps);
        assertThat(ghost.game().steps()).isEqualTo(steps);
        assertThat(ghost.game().pool().stateHash()).isEqualTo(again.game().pool().stateHash());
    }

    private static void frames(Session session, int count) {
        for (int i = 0; i < count; i++) {
            session.frame();
        }
    }

    @Test
    void itKeepsStepThroughPauseUndoSlowMotionAndRestart() {
        Session session = new Session(level, Accuracy.GAME);
        frames(session, 20);
        BestRun ghost = new BestRun(run());
        session.ghost(Optional.of(ghost));
        assertAt(ghost, 20);
        frames(session, 60);
        session.game().act("wall");
        frames(session, 40);
        assertAt(ghost, 120);
        session.togglePause();
        frames(session, 30);
        assertAt(ghost, 120);
        session.togglePause();
        assertThat(session.undo()).isTrue();
        assertAt(ghost, 80);
        session.pace(Pace.HALF);
        frames(session, 20);
        assertAt(ghost, 90);
        session.restart();
        assertAt(ghost, 0);
    }

    /** After the end of the best run the ghost waits there. */
    @Test
    void itWaitsAtItsEnd() {
        Session session = new Session(level, Accuracy.GAME);
        BestRun ghost = new BestRun(run());
        session.ghost(Optional.of(ghost));
        int end = run().steps();
        frames(session, end + 50);
        assertAt(ghost, end);
        session.game().act("wall");
        frames(session, 10);
        session.undo();
        assertAt(ghost, end);
    }

    private Scene opened() {
        director.replays = Optional.of(folder);
        return new PuzzleScene(director, List.of(level, level), 0);
    }

    private static long ghosts(Scene scene) {
        return RecordingCanvas.of(scene).moods().stream().filter(Mood.GHOST::equals).count();
    }

    private static void solve(Scene scene) {
        PlayedLevel.clickBox(scene);
        for (int i = 0; i < PlayedLevel.LONG_ENOUGH; i++) {
            scene.step();
        }
    }

    @Test
    void aSwitchShowsItOnceThereIsARunAndStaysForOtherLevels() {
        Scene scene = opened();
        assertThat(RecordingCanvas.of(scene).texts()).doesNotContain("Ghost");
        scene.keyPressed(Key.G);
        assertThat(RecordingCanvas.of(scene).texts()).contains("no run of yours yet");
        solve(scene);
        scene.keyPressed(Key.R);
        assertThat(RecordingCanvas.of(scene).texts()).contains("Ghost");
        assertThat(ghosts(scene)).as("off at first").isZero();
        scene.keyPressed(Key.G);
        assertThat(ghosts(scene)).isEqualTo(1);
        assertThat(ghosts(opened())).as("in the next window").isEqualTo(1);
        scene.keyPressed(Key.G);
        assertThat(ghosts(scene)).isZero();
        assertThat(ghosts(opened())).isZero();
    }

    /** The hint, which comes after three failures, makes the number of keys the largest. */
    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void itsKeyHasRoomBesideAllOthers(String language) {
        director.settings(director.settings().withLanguage(language));
        Scene scene = opened();
        solve(scene);
        scene.keyPressed(Key.R);
        for (int i = 0; i < 3; i++) {
            PlayedLevel.clickBox(scene);
            scene.step();
            scene.keyPressed(Key.R);
        }
        assertThat(RecordingCanvas.of(scene).texts()).contains("G", "H");
        assertThat(Legibility.faults(scene)).isEmpty();
    }

    /** Without a run there is no ghost, even if the player wants one. */
    @Test
    void itComesWithTheTryAfterTheFirstSolution() {
        director.settings(director.settings().withGhost(true));
        Scene scene = opened();
        solve(scene);
        assertThat(ghosts(scene)).isZero();
        scene.keyPressed(Key.R);
        assertThat(ghosts(scene)).isEqualTo(1);
    }
}
