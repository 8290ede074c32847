package rigibo.frontend.puzzle.rules;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.puzzle.level.StarLevels;

import java.util.ArrayList;
import java.util.List;

/** The games that earn a star: the ball stands on "box", and "wall" stands aside. */
class StarTest {

    private static PuzzleGame played(Level level, String clicks) {
        List<Act> acts = new ArrayList<>();
        for (String click : clicks.split(" ")) {
            String[] at = click.split("@");
            acts.add(new Act(Integer.parseInt(at[1]), at[0]));
        }
        Playback playback = new Playback(level, new Replay(level.hash(), acts, Accuracy.GAME));
        while (playback.game().outcome() == Outcome.RUNNING) {
            playback.step();
        }
        return playback.game();
    }

    /** The ball falls 1 m in 0.45 s, and the hold takes 3 s; the last click is in time. */
    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "'type': 'clicks', 'count': 2; box@60 wall@120; box@60",
                "'type': 'quick', 'seconds': 4; box@20; box@60",
                "'type': 'avoid', 'body': 'box'; box@0; box@60",
                "'type': 'avoid', 'material': 'rigibo'; box@0; box@60",
                "'type': 'touch', 'body': 'box'; box@60; box@0",
                "'type': 'keep', 'body': 'wall'; box@60; box@60 wall@120",
                "'type': 'clear'; box@60 wall@120; box@60",
                "'type': 'first', 'body': 'wall'; wall@60 box@120; box@60 wall@120",
            })
    void oneGameEarnsItAndAnotherDoesNot(String feat, String earning, String other) {
        Level level = StarLevels.level(feat);
        assertThat(played(level, earning).hasStar()).as(earning).isTrue();
        assertThat(played(level, other).isSolved()).as(other).isTrue();
        assertThat(played(level, other).hasStar()).as(other).isFalse();
    }

    /** A box that falls beside the platform is out of sight after 1.2 s. */
    @Test
    void whatFallsOutOfTheWorldIsSeenEvenIfItIsForgotten() {
        String text = StarLevels.text("'type': 'inside'");
        assertThat(played(LevelTexts.level(text), "box@60 wall@120").hasStar()).isTrue();
        String loose =
                "\"bodies\": [{\"id\": \"loose\", \"shape\": {\"type\": \"circle\", \"r\": 0.3},"
                        + " \"x\": 1, \"y\": 5, \"material\": \"iron\"},";
        Level spilling = LevelTexts.level(text.replace("\"bodies\": [", loose));
        PuzzleGame game = played(spilling, "box@60");
        assertThat(game.isSolved()).isTrue();
        assertThat(game.hasStar()).isFalse();
        assertThat(game.target("loose").orElseThrow().isAlive()).isFalse();
    }

    @Test
    void anExperimentEarnsNone() {
        Level level = StarLevels.level("'type': 'keep', 'body': 'wall'");
        PuzzleGame game = new PuzzleGame(level, Accuracy.GAME);
        game.experiment(level.world().effects());
        game.act("box");
        while (game.outcome() == Outcome.RUNNING) {
            game.step();
        }
        assertThat(game.outcome()).isEqualTo(Outcome.WON);
        assertThat(game.hasStar()).isFalse();
    }
}
