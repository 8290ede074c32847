package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import static rigibo.frontend.scene.Pointing.touch;

import org.junit.jupiter.api.Test;

import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.Scene;

import java.util.List;

class PauseTest {

    private static final List<String> WAYS = List.of("Resume", "Restart", "Levels", "Menu");

    private final PlayedLevel played = new PlayedLevel(PlayedLevel.twoBoxes());

    /** The selected button of the bar, found by the colour of its plate. */
    private String chosen() {
        return WAYS.stream()
                .filter(way -> inTheBar(way) && plateInTheBar(way).equals(Color.BRASS))
                .findFirst()
                .orElse("none");
    }

    private boolean inTheBar(String way) {
        return played.canvas().firstMiddleOf(way)[1] < View.BAR_FOOT;
    }

    private Color plateInTheBar(String way) {
        double[] at = played.canvas().firstMiddleOf(way);
        return played.canvas().plateAt(at[0], at[1]);
    }

    @Test
    void stopsTheTime() {
        played.turns(30).keys(Key.P).turns(30);
        assertThat(played.counts()).endsWith(" 0.5 s");
        played.keys(Key.P).turns(30);
        assertThat(played.counts()).endsWith(" 1.0 s");
    }

    @Test
    void offersItsWaysInTheirOrder() {
        played.keys(Key.P);
        assertThat(played.texts()).containsSubsequence(WAYS);
        assertThat(chosen()).isEqualTo("Resume");
        for (String way : List.of("Restart", "Levels", "Menu", "Resume")) {
            played.keys(Key.RIGHT);
            assertThat(chosen()).isEqualTo(way);
        }
        played.keys(Key.LEFT);
        assertThat(chosen()).isEqualTo("Menu");
    }

    @Test
    void enterDoesWhatTheChosenButtonSays() {
        played.keys(Key.P, Key.ENTER).turns(60);
        assertThat(played.counts()).as("goes on").endsWith(" 1.0 s");
        played.keys(Key.P, Key.RIGHT, Key.ENTER);
        assertThat(played.counts()).as("starts anew").endsWith(" 0.0 s");
        played.turns(6);
        assertThat(played.counts()).as("and runs").endsWith(" 0.1 s");
        played.keys(Key.P, Key.RIGHT, Key.RIGHT, Key.ENTER);
        played.keys(Key.RIGHT, Key.ENTER);
        assertThat(played.director.asked).containsExactly("levels", "menu");
    }

    @Test
    void theMouseDoesTheSame() {
        played.keys(Key.P);
        touch(played.scene, Layout.ALONE, "Resume");
        played.turns(60);
        assertThat(played.counts()).endsWith(" 1.0 s");
        played.keys(Key.P);
        touch(played.scene, Layout.ALONE, "Levels");
        touch(played.scene, Layout.ALONE, "Menu");
        assertThat(played.director.asked).containsExactly("levels", "menu");
    }

    @Test
    void boxesAreDeletedMeanwhile() {
        played.keys(Key.P).clickBox().turns(10);
        assertThat(played.counts()).startsWith("1 click ").endsWith(" 0.0 s");
        played.clickWall();
        assertThat(played.texts()).as("the cooldown stands still too").contains("Resume");
        assertThat(played.counts()).startsWith("1 click ");
    }

    @Test
    void aBoxChosenByKeysIsDeletedAndNoButtonPressed() {
        played.keys(Key.P, Key.TAB);
        assertThat(chosen()).isEqualTo("none");
        played.keys(Key.ENTER).turns(10);
        assertThat(played.counts()).startsWith("1 click ").endsWith(" 0.0 s");
    }

    @Test
    void coversNoneOfThePlay() {
        played.keys(Key.P);
        RecordingCanvas canvas = played.canvas();
        for (double y = View.BAR_FOOT + 1; y < View.KEYS_TOP; y++) {
            assertThat(canvas.isUnderPanel(Scene.WIDTH / 2.0, y)).as("at %s", y).isFalse();
        }
    }

    @Test
    void aTryThatIsOverCannotBePaused() {
        played.solve().keys(Key.P);
        assertThat(played.texts()).contains("Solved!").doesNotContain("Resume");
    }
}
