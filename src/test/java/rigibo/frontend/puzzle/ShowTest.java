package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;

/** The hint after three failures, the solution beside it, and the player's own try shown again. */
class ShowTest {

    private static final String DEMONSTRATION = "This is how it can be done";
    private static final String AGAIN = "Your try once more";
    private static final String SOLUTION = "Show solution (V)";

    private final PlayedLevel played = new PlayedLevel(PlayedLevel.twoBoxes());

    /** Gives up after a click that does not help. */
    private void fail() {
        played.clickWall().turns(5).keys(Key.R).turns(1);
    }

    private void failThrice() {
        for (int i = 0; i < 3; i++) {
            fail();
        }
    }

    @Test
    void thereIsNoHintBeforeThreeFailures() {
        fail();
        fail();
        played.keys(Key.H);
        assertThat(played.texts())
                .contains("a hint comes after 3 failures")
                .doesNotContain("Look below.", "Hint");
        fail();
        assertThat(played.texts()).contains("Hint");
    }

    @Test
    void aRestartWithoutAClickIsNoFailure() {
        for (int i = 0; i < 5; i++) {
            played.turns(5).keys(Key.R).turns(1);
        }
        assertThat(played.progress().failures()).isZero();
    }

    @Test
    void aLostTryCountsOnce() {
        PlayedLevel lost = new PlayedLevel(PlayedLevel.rollingOff());
        lost.turns(PlayedLevel.LONG_ENOUGH);
        assertThat(lost.texts()).contains("Lost");
        assertThat(lost.progress().failures()).isEqualTo(1);
        lost.keys(Key.R).turns(1);
        assertThat(lost.progress().failures()).isEqualTo(1);
    }

    @Test
    void theHintIsShownAndPutAwayByKeyAndByButton() {
        failThrice();
        played.keys(Key.H);
        assertThat(played.texts()).contains("Look below.", SOLUTION);
        played.keys(Key.H);
        assertThat(played.texts()).doesNotContain("Look below.");
        played.press("Hint");
        assertThat(played.texts()).contains("Look below.");
    }

    @Test
    void withoutTheHintNoKeyShowsTheSolution() {
        failThrice();
        played.keys(Key.V).turns(1);
        assertThat(played.texts()).doesNotContain(DEMONSTRATION);
    }

    @Test
    void theSolutionIsSeenToBeADemonstrationAndEarnsNothing() {
        failThrice();
        played.keys(Key.H).press(SOLUTION).turns(1);
        assertThat(played.texts()).contains(DEMONSTRATION, "Stop");
        assertThat(played.counts()).startsWith("0 clicks ");
        played.turns(60);
        assertThat(played.counts()).as("the stored click at 1 s").startsWith("1 click ");
        played.turns(4 * 60);
        assertThat(played.texts()).contains(DEMONSTRATION).doesNotContain("Solved!");
        assertThat(played.progress().isSolved()).isFalse();
        assertThat(played.progress().failures()).isEqualTo(3);
    }

    @Test
    void afterTheSolutionTheLevelStartsAnew() {
        failThrice();
        played.keys(Key.H, Key.V).turns(10 * 60);
        assertThat(played.texts())
                .doesNotContain(DEMONSTRATION)
                .contains("click a box to delete it");
        played.keys(Key.R).turns(1).solve();
        assertThat(played.texts()).contains("Solved!");
        assertThat(played.progress().isSolved()).isTrue();
    }

    @Test
    void clicksMeanwhileAreRefusedAndDeleteNothing() {
        failThrice();
        played.keys(Key.H, Key.V).turns(1).clickWall();
        assertThat(played.texts()).contains(DEMONSTRATION);
        assertThat(played.counts()).startsWith("0 clicks ");
        played.keys(Key.BACKSPACE, Key.E, Key.TAB, Key.ENTER);
        assertThat(played.texts()).doesNotContain("gravity");
    }

    @Test
    void escEndsWhatIsShownBeforeItLeavesTheLevel() {
        failThrice();
        played.keys(Key.H, Key.V).turns(30);
        assertThat(played.scene.escaped()).isTrue();
        assertThat(played.turns(1).texts()).doesNotContain(DEMONSTRATION);
        assertThat(played.scene.escaped()).isFalse();
    }

    @Test
    void aSolvedTryIsSeenOnceMoreAndCountsOnce() {
        played.turns(7).solve();
        String counts = played.counts();
        played.press("Watch replay").turns(10);
        assertThat(played.texts()).contains(AGAIN).doesNotContain("Solved!");
        assertThat(played.counts()).startsWith("1 click ").isNotEqualTo(counts);
        played.turns(10 * 60);
        assertThat(played.texts()).contains("Solved!");
        assertThat(played.counts()).isEqualTo(counts);
        assertThat(played.progress().fewestClicks()).hasValue(1);
    }

    @Test
    void aSolvedTrySaysAtItsEndWhetherItWentTheSame() {
        played.turns(7).solve().press("Watch replay").turns(10);
        assertThat(played.texts()).noneMatch(ShowTest::isVerdict);
        while (played.texts().contains(AGAIN)
                && played.texts().stream().noneMatch(ShowTest::isVerdict)) {
            played.turns(1);
        }
        assertThat(played.texts()).anyMatch(ShowTest::isVerdict).contains(AGAIN);
        assertThat(Legibility.faults(played.scene)).isEmpty();
        played.turns(10 * 60);
        assertThat(played.texts()).contains("Solved!").noneMatch(ShowTest::isVerdict);
    }

    private static boolean isVerdict(String words) {
        return words.startsWith("the same to the last bit");
    }
}
