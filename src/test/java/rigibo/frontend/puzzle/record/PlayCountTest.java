package rigibo.frontend.puzzle.record;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.puzzle.PlayedLevel;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Totals;

/** Counts of a player's tries. */
class PlayCountTest {

    private final PlayedLevel played = new PlayedLevel(PlayedLevel.twoBoxes());

    private Totals totals() {
        return played.director.progress().totals();
    }

    @Test
    void aTryCountsWithItsClicksAndItsTimeUntilItEnds() {
        played.solve();
        Totals first = totals();
        assertThat(first.tries()).isEqualTo(1);
        assertThat(first.clicks()).isEqualTo(1);
        assertThat(first.steps()).isBetween(200, 230);
        played.turns(300).keys(Key.R).turns(1);
        assertThat(totals()).as("what comes after the end is not played").isEqualTo(first);
    }

    @Test
    void whatIsTakenBackWasDoneAllTheSame() {
        played.clickWall().turns(60).keys(Key.BACKSPACE).turns(30).clickBox();
        played.turns(PlayedLevel.LONG_ENOUGH);
        assertThat(totals().tries()).isEqualTo(1);
        assertThat(totals().clicks()).isEqualTo(2);
        assertThat(totals().steps()).isBetween(280, 320);
    }

    @Test
    void aTryThatIsLeftCountsIfSomethingWasClicked() {
        played.turns(60).keys(Key.R).turns(1);
        assertThat(totals().tries()).isZero();
        played.clickWall().turns(60).keys(Key.R).turns(1);
        assertThat(totals().tries()).isEqualTo(1);
        played.clickWall().turns(60);
        played.scene.closed();
        assertThat(totals().tries()).isEqualTo(2);
        assertThat(totals().clicks()).isEqualTo(2);
        assertThat(totals().steps()).isBetween(170, 183);
    }

    @Test
    void whatIsOnlyWatchedIsNotPlayed() {
        played.solve();
        Totals before = totals();
        played.press("Watch replay").turns(PlayedLevel.LONG_ENOUGH);
        played.scene.closed();
        assertThat(totals()).isEqualTo(before);
    }
}
