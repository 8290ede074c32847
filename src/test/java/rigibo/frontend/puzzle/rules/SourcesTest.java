package rigibo.frontend.puzzle.rules;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Fan;
import rigibo.backend.effect.Friction;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.VerbLevels;

/** Fans and magnets of a level, switched by clicks. */
class SourcesTest {

    private final Level level = VerbLevels.sources();
    private final PuzzleGame game = new PuzzleGame(level, Accuracy.GAME);

    private RigidBody body(String id) {
        return ((Piece) game.target(id).orElseThrow()).body();
    }

    private void step(int count) {
        for (int i = 0; i < count; i++) {
            game.step();
        }
    }

    /**
     * A plank of 0.5 m and 90 kg, 0.3 m along the fan's stream, feels 2000 · 0.5 · 0.95 N against a
     * weight of 883 N. It swings about the place where both are equal, 0.7 m along the stream.
     */
    @Test
    void aFanThatIsSwitchedOnLiftsAPlank() {
        step(60);
        double low = body("plank").y();
        assertThat(low).isCloseTo(0.85, within(1e-4));
        assertThat(game.act("fan")).isEqualTo(ClickResult.DONE);
        double mass = body("plank").mass();
        double omega = Math.sqrt(2000 * 0.5 / (mass * 6));
        double middle = 0.55 + 6 * (1 - mass * 9.81 / (2000 * 0.5));
        step(90);
        double then = middle - (middle - low) * Math.cos(omega * 1.5);
        // The error of the integrator of GAME over a second and a half.
        assertThat(body("plank").y()).isCloseTo(then, within(1e-3));
        game.act("fan");
        step(120);
        assertThat(body("plank").y()).as("fallen again").isCloseTo(0.85, within(1e-3));
    }

    @Test
    void aMagnetLiftsIronAndNothingElse() {
        step(60);
        game.act("magnet");
        step(150);
        assertThat(body("iron").y()).isGreaterThan(4);
        assertThat(body("wood").y()).isCloseTo(0.6, within(1e-3));
        game.act("magnet");
        step(120);
        assertThat(body("iron").y()).isLessThan(1);
    }

    /** An experiment changes other effects; the streams go on. */
    @Test
    void anExperimentKeepsTheStreams() {
        game.act("fan");
        game.experiment(level.world().effects().without(Friction.class));
        assertThat(game.pool().effects().find(Fan.class).orElseThrow().jets()).hasSize(1);
    }

    @Test
    void aReplayPlaysToTheSameBits() {
        step(30);
        game.act("magnet");
        step(70);
        game.act("fan");
        step(100);
        Playback again = new Playback(level, game.replay());
        again.stepTo(game.steps());
        assertThat(again.game().pool().stateHash()).isEqualTo(game.pool().stateHash());
    }
}
