package rigibo.frontend.puzzle.rules;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelTexts;

import java.util.List;

class PuzzleGameTest {

    private static final String WALL = "\"material\": \"stone\", \"dynamic\": false";

    /** The valid level, with a wall that can be deleted, too. */
    private static final Level TWO_BOXES =
            LevelTexts.level(LevelTexts.with(WALL, WALL + ", \"deletable\": true"));

    private static PuzzleGame game(Level level) {
        return new PuzzleGame(level, Accuracy.GAME);
    }

    private static void step(PuzzleGame game, int count) {
        for (int i = 0; i < count; i++) {
            game.step();
        }
    }

    @Test
    void aClickDuringTheCooldownIsRefusedAndSaysSo() {
        PuzzleGame game = game(TWO_BOXES);
        assertThat(game.click(4.5, 1.85)).isEqualTo(ClickResult.DONE);
        step(game, 59);
        assertThat(game.click(8, 2)).isEqualTo(ClickResult.COOLING_DOWN);
        assertThat(game.clicks()).isEqualTo(1);
    }

    @Test
    void aClickExactlyAtTheCooldownsEndDeletes() {
        PuzzleGame game = game(TWO_BOXES);
        game.click(4.5, 1.85);
        step(game, 60);
        assertThat(game.cooldownLeft()).isZero();
        assertThat(game.click(8, 2)).isEqualTo(ClickResult.DONE);
    }

    @Test
    void theFirstClickNeedsNoWaiting() {
        assertThat(game(TWO_BOXES).click(4.5, 1.85)).isEqualTo(ClickResult.DONE);
    }

    @Test
    void theCooldownRunsDownEvenly() {
        PuzzleGame game = game(TWO_BOXES);
        game.click(4.5, 1.85);
        assertThat(game.cooldownLeft()).isEqualTo(1);
        step(game, 15);
        assertThat(game.cooldownLeft()).isEqualTo(0.75);
    }

    @Test
    void clicksOnNothingAndOnWhatStaysAreToldApart() {
        PuzzleGame game = game(LevelTexts.sound());
        assertThat(game.click(1, 9)).isEqualTo(ClickResult.NOTHING_THERE);
        assertThat(game.click(8, 2)).isEqualTo(ClickResult.NOT_CLICKABLE);
        assertThat(game.click(4.5, 2.7)).as("the ball").isEqualTo(ClickResult.NOT_CLICKABLE);
        assertThat(game.click(4.5, 1.2)).as("the platform").isEqualTo(ClickResult.NOT_CLICKABLE);
        assertThat(game.clicks()).isZero();
    }

    @Test
    void noMoreClicksThanTheLevelAllows() {
        String text =
                LevelTexts.with("\"par\": 1", "\"par\": 1, \"maxClicks\": 1")
                        .replace(WALL, WALL + ", \"deletable\": true");
        PuzzleGame game = game(LevelTexts.level(text));
        game.click(4.5, 1.85);
        step(game, 60);
        assertThat(game.click(8, 2)).isEqualTo(ClickResult.NO_CLICKS_LEFT);
    }

    @Test
    void theBallOnThePlatformForThreeSecondsWins() {
        PuzzleGame game = game(LevelTexts.sound());
        game.click(4.5, 1.85);
        int landed = 0;
        while (game.outcome() == Outcome.RUNNING && game.steps() < 600) {
            game.step();
            landed = landed == 0 && game.held() > 0 ? game.steps() - 1 : landed;
        }
        assertThat(game.outcome()).isEqualTo(Outcome.WON);
        assertThat(game.steps() - landed).isEqualTo(180);
        assertThat(game.seconds()).isEqualTo(game.steps() / 60.0);
    }

    @Test
    void aWonGameStaysWonAndTakesNoClick() {
        PuzzleGame game = game(LevelTexts.sound());
        game.click(4.5, 1.85);
        while (game.outcome() == Outcome.RUNNING) {
            game.step();
        }
        double seconds = game.seconds();
        step(game, 60);
        assertThat(game.outcome()).isEqualTo(Outcome.WON);
        assertThat(game.seconds()).isEqualTo(seconds);
        assertThat(game.click(8, 2)).isEqualTo(ClickResult.OVER);
    }

    /** The second ball stands on a shelf beside the platform, so the first alone does not win. */
    @Test
    void aLevelWithTwoBallsIsWonByBothOrNotAtAll() {
        String aside =
                LevelTexts.with(
                        "\"platform\"",
                        "\"moreBalls\": [{\"x\": 8, \"y\": 4.3, \"radius\": 0.3}], \"platform\"");
        PuzzleGame lonely = game(LevelTexts.level(aside));
        lonely.click(4.5, 1.85);
        step(lonely, 300);
        assertThat(lonely.balls()).hasSize(2);
        assertThat(lonely.held()).isZero();
        assertThat(lonely.outcome()).isNotEqualTo(Outcome.WON);

        PuzzleGame together =
                game(
                        LevelTexts.level(
                                aside.replace("\"x\": 8, \"y\": 4.3", "\"x\": 5.3, \"y\": 2.65")));
        together.click(4.5, 1.85);
        step(together, 300);
        assertThat(together.outcome()).isEqualTo(Outcome.WON);
    }

    @Test
    void oneOfTwoBallsThatLeavesTheWorldLosesTheGame() {
        String text =
                LevelTexts.with(
                        "\"platform\"",
                        "\"moreBalls\": [{\"x\": 1, \"y\": 2.7, \"radius\": 0.3}], \"platform\"");
        PuzzleGame game = game(LevelTexts.level(text));
        step(game, 120);
        assertThat(game.loss()).contains(Loss.LEFT_THE_WORLD);
    }

    /**
     * A box of 500 kg/m² in water of 1000 kg/m² floats half submerged (Archimedes), with its middle
     * on the surface. It comes to rest after its drag has damped a second or so of bobbing.
     */
    @Test
    void aBoxFloatsWithItsMiddleOnTheSurface() {
        String text =
                LevelTexts.with("[0, -9.81],", "[0, -9.81], \"water\": {\"level\": 2.6},")
                        .replace("\"restitution\"]", "\"restitution\", \"buoyancy\"]")
                        .replace("\"x\": 4.5, \"y\": 2.7", "\"x\": 8, \"y\": 4.35");
        PuzzleGame game = game(LevelTexts.level(text));
        step(game, 900);
        assertThat(game.pieces().get(0).body().y()).isCloseTo(2.6, within(0.001));
    }

    /** Free fall from y to below 0 takes √(2(y + r)/g) s; the ball starts beside all bodies. */
    @Test
    void aBallThatFallsPastEverythingLeavesTheWorld() {
        PuzzleGame game =
                game(
                        LevelTexts.level(
                                LevelTexts.with("\"ball\": {\"x\": 4.5", "\"ball\": {\"x\": 1")));
        int expected = (int) Math.ceil(60 * Math.sqrt(2 * (2.7 + 0.35) / 9.81));
        step(game, expected - 1);
        assertThat(game.outcome()).isEqualTo(Outcome.RUNNING);
        step(game, 1);
        assertThat(game.loss()).contains(Loss.LEFT_THE_WORLD);
    }

    @Test
    void aBallThatWasOnThePlatformRolledOff() {
        String text =
                LevelTexts.with(
                                "\"y\": 2.7, \"radius\": 0.35",
                                "\"y\": 1.71, \"radius\": 0.35, \"vx\": 4")
                        .replace(
                                "\"w\": 2, \"h\": 1}, \"x\": 4.5",
                                "\"w\": 1, \"h\": 1}, \"x\": 3.2");
        PuzzleGame game = game(LevelTexts.level(text));
        while (game.outcome() == Outcome.RUNNING && game.steps() < 600) {
            game.step();
        }
        assertThat(game.loss()).contains(Loss.ROLLED_OFF);
    }

    @Test
    void whenAllRestsElsewhereAndNothingIsLeftToDeleteTheGameIsLost() {
        String text =
                LevelTexts.with(
                                "\"ball\": {\"x\": 4.5, \"y\": 2.7",
                                "\"ball\": {\"x\": 8, \"y\": 4.35")
                        .replace("\"w\": 0.5, \"h\": 4", "\"w\": 1.8, \"h\": 4");
        PuzzleGame game = game(LevelTexts.level(text));
        step(game, 120);
        assertThat(game.isStuck()).isTrue();
        assertThat(game.outcome()).as("a box is left").isEqualTo(Outcome.RUNNING);
        game.click(4.5, 1.85);
        step(game, 120);
        assertThat(game.loss()).contains(Loss.NOTHING_LEFT_TO_DELETE);
    }

    @Test
    void theTimeLimitEndsTheGameAtItsStep() {
        PuzzleGame game =
                game(
                        LevelTexts.level(
                                LevelTexts.with("\"par\": 1", "\"par\": 1, \"timeLimit\": 2")));
        step(game, 119);
        assertThat(game.outcome()).isEqualTo(Outcome.RUNNING);
        step(game, 1);
        assertThat(game.loss()).contains(Loss.TIME_IS_UP);
    }

    @Test
    void theSameClicksAtTheSameStepsGiveTheSameBits() {
        PuzzleGame played = game(TWO_BOXES);
        step(played, 7);
        played.click(4.5, 1.85);
        step(played, 83);
        played.click(8, 2);
        step(played, 110);

        Playback again = new Playback(TWO_BOXES, played.replay());
        again.stepTo(200);

        assertThat(again.game().pool().stateHash()).isEqualTo(played.pool().stateHash());
        assertThat(again.refusal()).isEmpty();
        assertThat(again.game().replay()).isEqualTo(played.replay());
    }

    @Test
    void aReplayOfAnotherLevelIsRefused() {
        Replay other = new Replay(1, List.of(), Accuracy.GAME);
        assertThatThrownBy(() -> new Playback(TWO_BOXES, other))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("drop");
    }
}
