package rigibo.frontend.puzzle.show;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.PuzzleScene;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.RecordingSounds;
import rigibo.frontend.scene.Skin;

import java.util.List;

/** The sounds of a level: impacts, clicks, hold and end. */
class NoisesTest {

    private static final int SECOND = 60;

    private final RecordingSounds sounds = new RecordingSounds();
    private final PuzzleGame game = new PuzzleGame(LevelTexts.sound(), Accuracy.GAME);
    private final Noises noises = new Noises(sounds, game);

    private void play(PuzzleGame played, int steps) {
        for (int i = 0; i < steps; i++) {
            played.step();
            noises.stepped(played);
        }
    }

    @Test
    void whatRestsIsSilent() {
        play(game, 2 * SECOND);
        assertThat(sounds.knocks).isEmpty();
        assertThat(sounds.signals).isEmpty();
        assertThat(sounds.ticks).isEmpty();
    }

    @Test
    void aSolvedLevelKnocksTicksHigherAndHigherAndEndsInAChord() {
        play(game, SECOND);
        game.act("box");
        play(game, 6 * SECOND);
        assertThat(sounds.knocks)
                .isNotEmpty()
                .allSatisfy(knock -> assertThat(knock.skin()).isEqualTo(Skin.BALL));
        assertThat(sounds.signals).containsExactly("chord");
        // One each half second of 3 s; the sixth is the chord.
        assertThat(sounds.ticks).hasSize(5).isSorted();
    }

    @Test
    void aLostLevelFails() {
        PuzzleGame hurried =
                new PuzzleGame(
                        LevelTexts.level(
                                LevelTexts.with("\"par\": 1", "\"par\": 1, \"timeLimit\": 0.5")),
                        Accuracy.GAME);
        play(hurried, SECOND);
        assertThat(sounds.signals).containsExactly("fail");
    }

    /** The ball rolls without slipping: its rim is as fast as its centre. */
    @Test
    void aBallThatRollsIsHeardBySpeed() {
        play(game, SECOND);
        game.act("box");
        play(game, SECOND);
        sounds.rolling.clear();
        double speed = 1.5;
        RigidBody ball = game.balls().get(0);
        ball.velocity(speed, 0);
        ball.spin(-speed / ball.shape().boundingRadius());
        play(game, 5);
        assertThat(sounds.rolling)
                .hasSize(5)
                .allSatisfy(heard -> assertThat(heard).isCloseTo(speed, within(1e-3)));
    }

    @Test
    void whatWasHeardBeforeATryIsNotHeardAgainInTheNext() {
        play(game, SECOND);
        game.act("box");
        play(game, 6 * SECOND);
        sounds.signals.clear();
        play(new PuzzleGame(LevelTexts.sound(), Accuracy.GAME), SECOND);
        assertThat(sounds.signals).isEmpty();
    }

    @Test
    void theSceneTellsTheDirectorsSounds() {
        RecordingDirector director = new RecordingDirector();
        PuzzleScene scene = new PuzzleScene(director, List.of(LevelTexts.sound()), 0);
        scene.keyPressed(Key.TAB);
        scene.keyPressed(Key.ENTER);
        for (int i = 0; i < 6 * SECOND; i++) {
            scene.step();
        }
        assertThat(director.sounds.signals).containsExactly("pop", "chord");
        assertThat(director.sounds.knocks).isNotEmpty();
    }

    /** The wall stands at (8, 2) of a world of 9 × 10 m. */
    @Test
    void aRefusedClickIsHeardAndAClickIntoTheVoidIsNot() {
        RecordingDirector director = new RecordingDirector();
        PuzzleScene scene = new PuzzleScene(director, List.of(LevelTexts.sound()), 0);
        Camera camera = Camera.ofPuzzle();
        scene.pointerPressed(PointerButton.LEFT, camera.screenX(2), camera.screenY(7));
        assertThat(director.sounds.signals).isEmpty();
        scene.pointerPressed(PointerButton.LEFT, camera.screenX(8), camera.screenY(2));
        assertThat(director.sounds.signals).containsExactly("refuse");
    }
}
