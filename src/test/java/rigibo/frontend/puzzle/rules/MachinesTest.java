package rigibo.frontend.puzzle.rules;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyType;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.level.VerbLevels;

import java.util.List;

/** Motors and belts that are switched, bodies that freeze, bombs that are lit. */
class MachinesTest {

    private final Level level = VerbLevels.machines();
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
     * A torque of 1000 N·m turns a wheel of 59 kg·m² from rest to 4 rad/s in a quarter of a second.
     */
    @Test
    void aMotorDrivesWhileItIsOnAndLetsTheWheelRunOnAfterwards() {
        step(60);
        assertThat(body("wheel").angularVelocity()).as("off at first").isZero();
        assertThat(game.act("motor")).isEqualTo(ClickResult.DONE);
        step(60);
        assertThat(body("wheel").angularVelocity()).isCloseTo(4, within(1e-6));
        assertThat(game.act("motor")).isEqualTo(ClickResult.DONE);
        step(60);
        // The wheel hangs in its centre, and nothing brakes it.
        assertThat(body("wheel").angularVelocity()).isCloseTo(4, within(1e-6));
    }

    /** From rest to 2 m/s at μ·g with μ = √(0.9 · 0.4): 0.34 s and 0.34 m of the belt. */
    @Test
    void aBeltCarriesWhileItIsOn() {
        double before = body("crate").x();
        step(60);
        assertThat(body("crate").x()).as("off at first").isCloseTo(before, within(1e-6));
        game.act("belt");
        step(60);
        double time = 2 / (Math.sqrt(0.9 * 0.4) * 9.81);
        double way = 2 * (1 - time) + 2 * time / 2;
        // The belt begins with the step after the click.
        assertThat(body("crate").x() - before).isCloseTo(way, within(2.0 / 60));
        assertThat(body("crate").velocityX()).isCloseTo(2, within(1e-3));
        game.act("belt");
        step(60);
        assertThat(body("crate").velocityX()).isCloseTo(0, within(1e-3));
    }

    @Test
    void aSwitchCanBeClickedAgainAndAgain() {
        for (int i = 0; i < 4; i++) {
            assertThat(game.act("belt")).isEqualTo(ClickResult.DONE);
            assertThat(game.target("belt").orElseThrow().isOn()).isEqualTo(i % 2 == 0);
            step(60);
        }
    }

    @Test
    void aFrozenBodyIsAStoneThatStaysWhereItWas() {
        step(30);
        double y = body("faller").y();
        assertThat(body("faller").velocityY()).isLessThan(-4);
        assertThat(game.act("faller")).isEqualTo(ClickResult.DONE);
        step(120);
        Piece frozen = (Piece) game.target("faller").orElseThrow();
        assertThat(frozen.body().y()).isEqualTo(y);
        assertThat(frozen.body().type()).isEqualTo(BodyType.STATIC);
        assertThat(frozen.substance()).isEqualTo(Substance.STONE);
        assertThat(game.act("faller")).isEqualTo(ClickResult.NOT_CLICKABLE);
    }

    @Test
    void aBombBlowsUpASecondAfterItWasLit() {
        step(30);
        assertThat(game.act("bomb")).isEqualTo(ClickResult.DONE);
        Piece bomb = (Piece) game.target("bomb").orElseThrow();
        step(30);
        assertThat(bomb.fuse().orElseThrow().burnt(game.steps())).isEqualTo(0.5);
        step(30);
        assertThat(bomb.isAlive()).isTrue();
        assertThat(body("mark").velocityX()).isCloseTo(0, within(1e-6));
        step(1);
        assertThat(bomb.isAlive()).isFalse();
        assertThat(body("mark").velocityX()).isGreaterThan(0.3);
    }

    /**
     * Each bomb explodes a second after the one that lit it; the last is a centimetre out of reach.
     */
    @Test
    void aBlastLightsTheBombsWithinItsReach() {
        Level bombs = VerbLevels.of(VerbLevels.BOMBS);
        PuzzleGame chain = new PuzzleGame(bombs, Accuracy.GAME);
        assertThat(chain.act("first")).isEqualTo(ClickResult.DONE);
        List<String> row = List.of("first", "near", "next");
        for (int i = 0; i < row.size(); i++) {
            Target bomb = chain.target(row.get(i)).orElseThrow();
            for (int step = 0; step < 60; step++) {
                chain.step();
                assertThat(bomb.isAlive()).isTrue();
                assertThat(chain.isStuck()).as("a fuse burns").isFalse();
            }
            assertThat(((Piece) bomb).fuse().orElseThrow().burnt(chain.steps())).isEqualTo(1);
        }
        for (int step = 0; step < 120; step++) {
            chain.step();
        }
        assertThat(chain.target("next").orElseThrow().isAlive()).isFalse();
        assertThat(chain.target("far").orElseThrow().isClickable()).isTrue();
        assertThat(chain.clicks()).isEqualTo(1);

        Playback again = new Playback(bombs, chain.replay());
        again.stepTo(chain.steps());
        assertThat(again.game().pool().stateHash()).isEqualTo(chain.pool().stateHash());
    }

    @Test
    void whatBurnsCannotBeLitAgain() {
        game.act("bomb");
        step(60);
        assertThat(game.act("bomb")).isIn(ClickResult.NOT_CLICKABLE, ClickResult.NOTHING_THERE);
        assertThat(game.clicks()).isEqualTo(1);
    }

    /** All bodies lie still while the fuse burns, but will move. */
    @Test
    void nothingIsLostWhileAFuseBurns() {
        step(300);
        assertThat(game.isStuck()).as("at rest beside the platform").isTrue();
        game.act("bomb");
        for (int i = 0; i < 60; i++) {
            game.step();
            assertThat(game.isStuck()).isFalse();
        }
    }

    @Test
    void aLevelWithASwitchIsNeverLostForWantOfClicks() {
        step(600);
        assertThat(game.outcome()).isEqualTo(Outcome.RUNNING);
    }

    @Test
    void aReplayOfAllVerbsPlaysToTheSameBits() {
        for (String target : List.of("faller", "belt", "motor", "bomb", "belt")) {
            step(70);
            assertThat(game.act(target)).isEqualTo(ClickResult.DONE);
        }
        step(100);
        Playback again = new Playback(level, game.replay());
        again.stepTo(game.steps());
        assertThat(again.refusal()).isEmpty();
        assertThat(again.game().pool().stateHash()).isEqualTo(game.pool().stateHash());
    }
}
