package rigibo.frontend.puzzle.hud;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.frontend.document.Problems;
import rigibo.frontend.document.ShareCode;
import rigibo.frontend.puzzle.Levels;
import rigibo.frontend.puzzle.PlayedLevel;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.StarLevels;
import rigibo.frontend.puzzle.replay.LoadedReplay;
import rigibo.frontend.puzzle.replay.Proof;
import rigibo.frontend.puzzle.replay.ReplayLoader;
import rigibo.frontend.puzzle.rules.Loss;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingNarrator;
import rigibo.frontend.scene.Settings;
import rigibo.frontend.scene.Words;

import java.util.List;

/** The panel after a win or a loss, and its commands. */
class EndOfATryTest {

    /** Number of pieces thrown at a victory. */
    private static final int CONFETTI = 120;

    private final PlayedLevel played = new PlayedLevel(PlayedLevel.twoBoxes());

    private PlayedLevel lost() {
        return new PlayedLevel(PlayedLevel.rollingOff()).turns(PlayedLevel.LONG_ENOUGH);
    }

    /** Plays until the moment of victory. */
    private void win() {
        played.clickBox();
        while (!played.texts().contains("Solved!")) {
            played.turns(1);
        }
    }

    /** The ranks on the stamped medals. */
    private String ranks() {
        return String.join(
                "", played.texts().stream().filter(words -> words.matches("[123]")).toList());
    }

    @Test
    void theStarIsAQuestionUntilItIsEarned() {
        Level level = StarLevels.level("'type': 'clear'");
        PlayedLevel starred = new PlayedLevel(level).solve();
        assertThat(starred.texts())
                .contains("?", "secret star", "A secret star is hidden here.")
                .doesNotContain("Well done.");
        assertThat(starred.director.progress().of(level.id(), level.hash()).hasStar()).isFalse();
        starred.keys(Key.R).clickBox().turns(90).clickWall().turns(PlayedLevel.LONG_ENOUGH);
        assertThat(starred.texts()).contains("Well done.").doesNotContain("?");
        assertThat(starred.director.progress().of(level.id(), level.hash()).hasStar()).isTrue();
        starred.keys(Key.R).solve();
        assertThat(starred.texts()).as("found before").contains("Well done.");
    }

    @Test
    void theEndIsSaidAndItsButtonsHaveNames() {
        win();
        RecordingNarrator told = RecordingNarrator.of(played.scene);
        assertThat(told.said()).contains("Solved!", "gold: 1 click");
        RecordingNarrator.press(played.scene, told.control("Next level"));
        assertThat(played.director.shown).hasSize(1);
        RecordingNarrator lost = RecordingNarrator.of(lost().scene);
        assertThat(lost.said()).contains("Lost", "The ball rolled off.");
    }

    @Test
    void medalsAreStampedOneByOneUpToTheOneEarned() {
        win();
        assertThat(ranks()).isEmpty();
        assertThat(played.turns(15).texts()).contains("bronze: solved", "silver: 2 clicks");
        assertThat(ranks()).isEqualTo("3");
        played.turns(15);
        assertThat(ranks()).isEqualTo("32");
        played.turns(15);
        assertThat(ranks()).isEqualTo("321");
    }

    @Test
    void namesOfMedalsAreShortWhereLongOnesWouldTouch() {
        PlayedLevel german =
                new PlayedLevel(PlayedLevel.twoBoxes(), "de", Settings.Motion.REDUCED).solve();
        Layout large = Layout.ALONE.withText(1.3, german.scene.mostType());
        assertThat(german.texts()).contains("Bronze: gelöst", "Silber: 2 Klicks");
        assertThat(RecordingCanvas.of(german.scene, large).texts())
                .contains("Bronze", "Silber", "Gold");
    }

    @Test
    void oneClickMoreThanParIsSilver() {
        played.clickWall().turns(60).solve();
        assertThat(ranks()).isEqualTo("32");
        assertThat(played.progress().fewestClicks()).hasValue(2);
    }

    @Test
    void theFewestClicksAreKept() {
        played.clickWall().turns(60).solve().keys(Key.R).turns(1).solve();
        assertThat(played.progress().fewestClicks()).hasValue(1);
        played.keys(Key.R).turns(1).clickWall().turns(60).solve();
        assertThat(played.progress().fewestClicks()).hasValue(1);
    }

    @Test
    void enterGoesOnToTheNextLevel() {
        played.solve().keys(Key.ENTER);
        assertThat(played.director.shown).hasSize(1);
    }

    @Test
    void theOtherWaysAreChosenByArrowsOrClicked() {
        played.solve();
        assertThat(played.texts())
                .containsSubsequence("Next level", "Restart", "Watch replay", "Levels");
        played.keys(Key.LEFT, Key.ENTER);
        assertThat(played.director.asked).containsExactly("levels");
        played.press("Next level");
        assertThat(played.director.shown).hasSize(1);
    }

    @Test
    void aSolvedTryIsCopiedAsACodeThatPlaysBackTheSame() {
        played.keys(Key.C);
        assertThat(played.director.copied).as("before it is solved").isEmpty();
        played.solve().press("Copy as code");
        String code = played.director.copied.get(0);
        String text = ShareCode.read(code, new Problems("code")).orElseThrow().text();
        LoadedReplay read = new ReplayLoader(List.of(played.level)).parse("code", text);
        assertThat(read.problems()).isEmpty();
        assertThat(Proof.of(read.recording().orElseThrow()).isSame()).isTrue();
    }

    /** If one click is enough, there is no time between clicks to gain. */
    @Test
    void aLossWithMoreThanOneClickTellsOfThePause() {
        String tip = "P pauses, and clicks count while the world stands still.";
        PlayedLevel first = new PlayedLevel(Levels.all().get(0));
        for (int i = 0; i < 5 && !first.texts().contains("Lost"); i++) {
            first.keys(Key.TAB, Key.ENTER).turns(120);
        }
        first.turns(PlayedLevel.LONG_ENOUGH);
        assertThat(first.texts()).contains("Lost", tip);
        assertThat(lost().texts()).contains("Lost").doesNotContain(tip);
    }

    @Test
    void aLossSaysWhyAndDimsTheWorld() {
        PlayedLevel lost = lost();
        assertThat(lost.texts()).contains("Lost", "The ball rolled off.");
        assertThat(lost.canvas().veil()).isPositive();
        assertThat(played.canvas().veil()).isZero();
        assertThat(lost.canvas().rings()).anyMatch(ring -> ring.color().equals(Color.BAD));
    }

    @ParameterizedTest
    @EnumSource(Loss.class)
    void everyLossHasWordsInEveryLanguage(Loss loss) {
        for (String language : Settings.LANGUAGES) {
            assertThat(new Words(language).of("puzzle.loss." + Command.key(loss))).isNotBlank();
        }
    }

    @Test
    void restartBeginsAtOnceInTheSameWindow() {
        PlayedLevel lost = lost();
        lost.keys(Key.R);
        assertThat(lost.counts()).isEqualTo("0 clicks 0.0 s");
        assertThat(lost.turns(1).texts()).doesNotContain("Lost");
        assertThat(lost.director.shown).isEmpty();
    }

    @Test
    void aLossIsTakenBackWithItsClick() {
        played.clickWall().turns(60).clickBox().turns(2);
        assertThat(played.counts()).startsWith("2 clicks");
        played.keys(Key.BACKSPACE);
        assertThat(played.counts()).isEqualTo("1 click 1.0 s");
        played.turns(1).press("Undo");
        assertThat(played.counts()).isEqualTo("0 clicks 0.0 s");
    }

    @Test
    void anEndIsTakenBackToo() {
        played.solve().keys(Key.BACKSPACE).turns(1);
        assertThat(played.texts()).doesNotContain("Solved!");
        assertThat(played.counts()).startsWith("0 clicks ");
    }

    @Test
    void withReducedMotionThereIsNoConfetti() {
        PlayedLevel calm = new PlayedLevel(PlayedLevel.twoBoxes(), "en", Settings.Motion.REDUCED);
        win();
        played.turns(1);
        calm.solve();
        assertThat(played.canvas().particles())
                .as("besides what else there is to see")
                .hasSizeGreaterThan(calm.canvas().particles().size() + CONFETTI / 2);
    }
}
