package rigibo.frontend.puzzle.rules;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.setup.Accuracy;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelTexts;

import java.util.List;

class BookmarksTest {

    private static final String WALL = "\"material\": \"stone\", \"dynamic\": false";

    /** As the sound level, and its wall can be deleted too. */
    private static final Level TWO_BOXES =
            LevelTexts.level(LevelTexts.with(WALL, WALL + ", \"deletable\": true"));

    private static final List<Act> CLICKS = List.of(new Act(90, "wall"), new Act(160, "box"));

    private static Playback playback() {
        return new Playback(TWO_BOXES, replay());
    }

    private static Replay replay() {
        return new Replay(TWO_BOXES.hash(), CLICKS, Accuracy.GAME);
    }

    private static PuzzleGame ended(Playback playback) {
        while (playback.game().outcome() == Outcome.RUNNING) {
            playback.step();
        }
        return playback.game();
    }

    /** Before a click, within its cooldown, while the ball falls, and while it is held. */
    @ParameterizedTest
    @ValueSource(ints = {0, 90, 120, 170, 260, 300})
    void gameGoesOnToItsOwnBitsAsOftenAsOneLikes(int step) {
        Playback whole = playback();
        Playback begun = playback();
        begun.stepTo(step);
        Bookmarks.Bookmark kept = new Bookmarks(TWO_BOXES).at(begun.game());
        PuzzleGame end = ended(whole);
        for (int time = 0; time < 2; time++) {
            PuzzleGame again = ended(new Playback(kept.game(), replay()));
            assertThat(again.outcome()).isEqualTo(Outcome.WON);
            assertThat(again.steps()).isEqualTo(end.steps());
            assertThat(again.checkpoints()).isEqualTo(end.checkpoints());
            assertThat(again.replay()).isEqualTo(end.replay());
        }
        assertThat(begun.game().steps()).isEqualTo(step);
    }

    @Test
    void whatIsGoneStaysGone() {
        Playback begun = playback();
        begun.stepTo(200);
        PuzzleGame again = new Bookmarks(TWO_BOXES).at(begun.game()).game();
        assertThat(again.act("wall")).isEqualTo(ClickResult.NOTHING_THERE);
        assertThat(again.targets()).noneMatch(Target::isAlive);
    }

    @Test
    void levelWhoseRulesRememberMoreIsRefused() {
        Level door =
                LevelTexts.level(
                        LevelTexts.with(WALL, WALL.replace("stone", "ember"))
                                .replace("\"format\": 1", "\"format\": 2"));
        assertThat(Bookmarks.fit(TWO_BOXES)).isTrue();
        assertThat(Bookmarks.fit(door)).isFalse();
        assertThatThrownBy(() -> new Bookmarks(door))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("clicks do more than delete in drop");
    }
}
