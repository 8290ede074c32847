package rigibo.frontend.puzzle.show;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.session.Session;
import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Canvas.Mood;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.Settings.Motion;

/** Animations follow the game, whatever the origin of the clicks. */
class SpectacleTest {

    /** Turns in which the fall and the hold of 3 s are over. */
    private static final int LONG_ENOUGH = 8 * 60;

    private final Session session = new Session(LevelTexts.sound(), Accuracy.GAME);
    private final Spectacle spectacle = new Spectacle(session);

    private void turns(int count) {
        for (int i = 0; i < count; i++) {
            session.frame();
            spectacle.frame();
        }
    }

    private RecordingCanvas drawn(Motion motion) {
        RecordingCanvas canvas = new RecordingCanvas();
        spectacle.draw(canvas, Camera.ofPuzzle(), motion);
        return canvas;
    }

    private int particles() {
        return drawn(Motion.FULL).particles().size();
    }

    private void deleteTheBox() {
        session.game().click(4.5, 1.85);
    }

    @Test
    void aDeletedBoxIsSquashedForAMomentAndBurstsThen() {
        turns(1);
        int still = particles();
        deleteTheBox();
        turns(1);
        assertThat(drawn(Motion.FULL).moods()).containsExactly(Mood.HOVERED);
        assertThat(particles()).isEqualTo(still);
        // 80 ms are five turns of 1/60 s.
        turns(5);
        assertThat(drawn(Motion.FULL).moods()).isEmpty();
        assertThat(particles()).isGreaterThan(still);
    }

    @Test
    void anotherAttemptBeginsWithClearAir() {
        turns(1);
        int still = particles();
        deleteTheBox();
        turns(10);
        session.restart();
        turns(1);
        assertThat(particles()).isEqualTo(still);
        assertThat(drawn(Motion.FULL).puffs()).isZero();
    }

    @Test
    void theBallGlowsWhileItIsHeldAndConfettiFliesWhenThatIsDone() {
        PuzzleGame game = session.game();
        turns(1);
        assertThat(drawn(Motion.FULL).glows()).isZero();
        deleteTheBox();
        while (game.outcome() == Outcome.RUNNING && game.steps() < LONG_ENOUGH) {
            turns(1);
        }
        assertThat(game.isSolved()).isTrue();
        assertThat(drawn(Motion.FULL).glows()).isOne();
        int still = particles();
        spectacle.celebrate();
        assertThat(particles()).isGreaterThan(still + 100);
        assertThat(spectacle.mood(game.pieces().get(1))).isEqualTo(Mood.CHEERING);
    }

    @Test
    void aLostWorldTurnsGreySlowlyOrAtOnceWhereLessIsToMove() {
        PuzzleGame game = session.game();
        turns(1);
        assertThat(drawn(Motion.FULL).veil()).isZero();
        game.balls().get(0).velocity(-30, 0);
        while (game.outcome() == Outcome.RUNNING && game.steps() < LONG_ENOUGH) {
            turns(1);
        }
        assertThat(game.outcome()).isEqualTo(Outcome.LOST);
        assertThat(drawn(Motion.FULL).veil()).isStrictlyBetween(0.0, 0.5);
        assertThat(drawn(Motion.REDUCED).veil()).isOne();
        turns(60);
        assertThat(drawn(Motion.FULL).veil()).isOne();
    }
}
