package rigibo.frontend.puzzle.rules;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Substance;
import rigibo.frontend.puzzle.level.VerbLevels;

/** Bodies of ember melt half a second after a ball has touched them, unless they become stone. */
class FireDoorsTest {

    /** A fall of 2 m takes √(2·2/g) = 0.639 s, which ends within step 39. */
    private static final int LANDS = 39;

    private static final int MELTS = 30;

    private final Level level = VerbLevels.of(VerbLevels.EMBERS);
    private final PuzzleGame game = new PuzzleGame(level, Accuracy.GAME);

    private static Piece piece(PuzzleGame of, String id) {
        return (Piece) of.target(id).orElseThrow();
    }

    private static void step(PuzzleGame game, int count) {
        for (int i = 0; i < count; i++) {
            game.step();
        }
    }

    @Test
    void meltsHalfASecondAfterTheBallTouchedIt() {
        Piece plate = piece(game, "plate");
        step(game, LANDS - 1);
        assertThat(plate.melt()).as("not touched yet").isEmpty();
        step(game, 1);
        assertThat(plate.melt()).contains(new Melt(LANDS));
        step(game, MELTS);
        assertThat(plate.isAlive()).isTrue();
        assertThat(plate.melt().orElseThrow().share(game.steps())).isEqualTo(1);
        step(game, 1);
        assertThat(plate.isAlive()).isFalse();
    }

    @Test
    void staysUnderWhatIsNoBall() {
        step(game, 300);
        assertThat(piece(game, "other").isAlive()).isTrue();
        assertThat(piece(game, "other").melt()).isEmpty();
    }

    @Test
    void isAStoneThatStaysOnceItWasFrozenBefore() {
        game.act("plate");
        step(game, 300);
        assertThat(piece(game, "plate").isAlive()).isTrue();
        assertThat(piece(game, "plate").substance()).isEqualTo(Substance.STONE);
    }

    @Test
    void canStillBeFrozenWhileItMelts() {
        step(game, LANDS + MELTS / 2);
        assertThat(game.act("plate")).isEqualTo(ClickResult.DONE);
        step(game, 300);
        assertThat(piece(game, "plate").isAlive()).isTrue();
        assertThat(piece(game, "plate").melt()).isEmpty();
    }

    /** The ball lies still on the door, but will fall. */
    @Test
    void nothingIsLostWhileItMelts() {
        step(game, LANDS);
        for (int i = 0; i < MELTS; i++) {
            assertThat(game.stillSteps()).isZero();
            game.step();
        }
    }

    @Test
    void isPlayedAgainToTheSameBits() {
        step(game, LANDS + MELTS + 20);
        Playback again = new Playback(level, game.replay());
        again.stepTo(game.steps());
        assertThat(again.game().pool().stateHash()).isEqualTo(game.pool().stateHash());
        assertThat(piece(again.game(), "plate").isAlive()).isFalse();
    }

    /** A stone could have all numbers of ember, and yet the level would play otherwise. */
    @Test
    void tellsItsLevelFromOneOfStone() {
        String likeEmber = "\"stone\", \"density\": 2000, \"friction\": 0.5, \"restitution\": 0";
        String stone = VerbLevels.EMBERS.replace("\"ember\"", likeEmber);
        Level other = VerbLevels.of(stone);
        assertThat(other.bodies().get(1).material()).isEqualTo(level.bodies().get(1).material());
        assertThat(other.hash()).isNotEqualTo(level.hash());
    }
}
