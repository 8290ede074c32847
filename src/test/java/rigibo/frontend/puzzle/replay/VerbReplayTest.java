package rigibo.frontend.puzzle.replay;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.VerbLevels;
import rigibo.frontend.puzzle.rules.PuzzleGame;

import java.util.List;

/** Clicks on joints in replay files. */
class VerbReplayTest {

    private static Recording played(Level level, String target) {
        PuzzleGame game = new PuzzleGame(level, Accuracy.GAME);
        for (int i = 0; i < 200; i++) {
            if (i == 30) {
                game.act(target);
            }
            game.step();
        }
        return Recording.of(game);
    }

    @Test
    void aCutIsWrittenAsAClickOnAJointAndPlaysBackTheSame() {
        Level level = VerbLevels.rope();
        String text = ReplayText.of(played(level, "line"));
        assertThat(text).contains("\"joint\" : \"line\"").doesNotContain("\"body\"");
        LoadedReplay loaded = new ReplayLoader(List.of(level)).parse("a.json", text);
        assertThat(loaded.problems()).isEmpty();
        assertThat(Proof.of(loaded.recording().orElseThrow()).isSame()).isTrue();
    }

    @Test
    void aDeletionIsWrittenAsBefore() {
        String text = ReplayText.of(played(VerbLevels.rope(), "hook"));
        assertThat(text).contains("\"body\" : \"hook\"").doesNotContain("\"joint\"");
    }

    @Test
    void aClickOnNeitherOrBothIsRefused() {
        Level level = VerbLevels.rope();
        String text = ReplayText.of(played(level, "line"));
        String named = "\"joint\" : \"line\"";
        ReplayLoader loader = new ReplayLoader(List.of(level));
        assertThat(loader.parse("a", text.replace(named, "\"at\" : 1")).recording()).isEmpty();
        assertThat(
                        loader.parse("a", text.replace(named, named + ", \"body\" : \"hook\""))
                                .recording())
                .isEmpty();
    }
}
