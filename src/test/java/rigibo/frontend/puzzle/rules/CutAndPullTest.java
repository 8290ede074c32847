package rigibo.frontend.puzzle.rules;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.VerbLevels;

import java.util.List;

/** Ropes that are cut and pins that are pulled, by the rules of all clicks. */
class CutAndPullTest {

    private static PuzzleGame game(Level level) {
        return new PuzzleGame(level, Accuracy.GAME);
    }

    private static void step(PuzzleGame game, int count) {
        for (int i = 0; i < count; i++) {
            game.step();
        }
    }

    /** The ball hangs at rest; cut loose, it falls by g·t²/2 in half a second. */
    @Test
    void aCutRopeLetsGoOfWhatHungOnIt() {
        PuzzleGame game = game(VerbLevels.rope());
        step(game, 60);
        RigidBody ball = game.balls().get(0);
        double before = ball.y();
        assertThat(game.act("line")).isEqualTo(ClickResult.DONE);
        step(game, 30);
        // A step is exact for a parabola.
        assertThat(before - ball.y()).isCloseTo(9.81 * 0.5 * 0.5 / 2, within(1e-9));
        assertThat(game.target("line").orElseThrow().isAlive()).isFalse();
        assertThat(game.clicks()).isEqualTo(1);
    }

    @Test
    void aRopeIsFoundAlongAllOfItsLine() {
        for (double y = 5.2; y < 7.9; y += 0.3) {
            assertThat(game(VerbLevels.rope()).click(2.05, y)).isEqualTo(ClickResult.DONE);
        }
        assertThat(game(VerbLevels.rope()).click(2.2, 6.5)).isEqualTo(ClickResult.NOTHING_THERE);
    }

    /** A slack rope sags: it is found at its drawing, not between its ends. */
    @Test
    void aSlackRopeIsFoundWhereItSags() {
        PuzzleGame game = game(VerbLevels.slackRope());
        List<Target> all = game.targets();
        Link link = (Link) all.get(all.size() - 1);
        double sag = link.a().y() - link.y();
        // The length of a parabola of depth d over a span s is about s + 8d²/3s: 4.5 m over 4 m.
        assertThat(sag).isCloseTo(Math.sqrt(3.0 / 8 * 4 * 0.5), within(0.05));
        assertThat(game.click(link.x(), link.a().y())).isEqualTo(ClickResult.NOTHING_THERE);
        assertThat(game.click(link.x(), link.y())).isEqualTo(ClickResult.DONE);
    }

    @Test
    void ropesThatAreNotMarkedStay() {
        PuzzleGame game = game(VerbLevels.of(VerbLevels.ROPE.replace("\"click\": \"cut\", ", "")));
        assertThat(game.click(2, 6.5)).isEqualTo(ClickResult.NOTHING_THERE);
        assertThat(game.act("line")).isEqualTo(ClickResult.NOTHING_THERE);
    }

    /** A click on both the box and the rope behind it means the box. */
    @Test
    void aBoxThatCanBeDeletedComesBeforeARope() {
        PuzzleGame game = game(VerbLevels.rope());
        assertThat(game.targetAt(2, 8.1)).map(Target::id).contains("hook");
        assertThat(game.targetAt(2, 7.9)).map(Target::id).contains("line");
    }

    @Test
    void theCooldownHoldsForEveryVerb() {
        PuzzleGame game = game(VerbLevels.rope());
        assertThat(game.act("line")).isEqualTo(ClickResult.DONE);
        step(game, 59);
        assertThat(game.act("hook")).isEqualTo(ClickResult.COOLING_DOWN);
        step(game, 1);
        assertThat(game.act("hook")).isEqualTo(ClickResult.DONE);
    }

    @Test
    void whatIsCutCannotBeCutAgain() {
        PuzzleGame game = game(VerbLevels.rope());
        game.act("line");
        step(game, 60);
        assertThat(game.act("line")).isEqualTo(ClickResult.NOTHING_THERE);
        assertThat(game.click(2, 7)).isEqualTo(ClickResult.NOTHING_THERE);
    }

    /** Deleting the box deletes its rope, which is no remaining target. */
    @Test
    void aRopeGoesWithItsBody() {
        PuzzleGame game = game(VerbLevels.rope());
        game.act("hook");
        assertThat(game.target("line").orElseThrow().isClickable()).isFalse();
    }

    /** When one of two pins that hold a bar level is pulled, the bar turns about the other. */
    @Test
    void aPulledPinLetsGoAndTheOtherHolds() {
        PuzzleGame game = game(VerbLevels.pin());
        step(game, 60);
        RigidBody bar = game.pieces().get(1).body();
        assertThat(bar.angle()).isCloseTo(0, within(1e-6));
        assertThat(game.click(7, 5)).isEqualTo(ClickResult.DONE);
        step(game, 20);
        assertThat(bar.angle()).isLessThan(-0.1);
        // The point at the other pin stays in place, to a joint's tolerance at GAME.
        assertThat(bar.worldX(-1, 0)).isCloseTo(5, within(1e-3));
        assertThat(bar.worldY(-1, 0)).isCloseTo(5, within(1e-3));
    }

    /** A pin is drawn over its body, so it has precedence even over a clickable body. */
    @Test
    void aPinComesBeforeTheBoxThatItHolds() {
        String deletable = VerbLevels.PIN.replace("\"rigibo\"", "\"rigibo\", \"deletable\": true");
        PuzzleGame game = game(VerbLevels.of(deletable));
        assertThat(game.targetAt(7, 5)).map(Target::id).contains("pin");
        assertThat(game.targetAt(6.4, 5)).map(Target::id).contains("bar");
    }

    @Test
    void aReplayOfACutPlaysToTheSameBits() {
        Level level = VerbLevels.rope();
        PuzzleGame game = game(level);
        step(game, 40);
        game.act("line");
        step(game, 100);
        Playback again = new Playback(level, game.replay());
        again.stepTo(game.steps());
        assertThat(again.refusal()).isEmpty();
        assertThat(again.game().pool().stateHash()).isEqualTo(game.pool().stateHash());
    }

    @Test
    void withNothingLeftToClickTheLevelIsLostAndSaysSo() {
        String without = VerbLevels.ROPE.replace(", \"deletable\": true", "");
        PuzzleGame game =
                game(
                        VerbLevels.of(
                                without.replace("\"x\": 2, \"y\": 1.2", "\"x\": 7, \"y\": 1.2")));
        game.act("line");
        for (int i = 0; i < 1200 && game.outcome() == Outcome.RUNNING; i++) {
            game.step();
        }
        assertThat(game.loss()).contains(Loss.NOTHING_LEFT_TO_CLICK);
    }
}
