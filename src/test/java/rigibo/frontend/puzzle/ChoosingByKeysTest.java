package rigibo.frontend.puzzle;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.puzzle.level.LevelTexts;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.RecordingCanvas;

import java.util.Arrays;

/**
 * Tab and arrows select boxes, Enter deletes one. The box is in the middle, the wall to its right.
 */
class ChoosingByKeysTest {

    private static final String NONE = "none";

    private final PlayedLevel played = new PlayedLevel(PlayedLevel.twoBoxes());

    /** The body with the four corners of a selection around it. */
    private String marked() {
        RecordingCanvas canvas = played.canvas();
        double[] places =
                canvas.lines().stream()
                        .filter(line -> line.color().equals(Color.TEXT))
                        .mapToDouble(RecordingCanvas.Line::x1)
                        .toArray();
        if (places.length == 0) {
            return NONE;
        }
        assertThat(places).as("two lines for each corner").hasSize(8);
        assertThat(canvas.moods()).as("and it is lifted").contains(Canvas.Mood.HOVERED);
        double middle = Arrays.stream(places).average().orElseThrow();
        return middle > 500 ? "wall" : "box";
    }

    @Test
    void tabGoesThroughAllThatCanBeDeletedAndShiftTabBack() {
        assertThat(marked()).isEqualTo(NONE);
        played.keys(Key.TAB);
        assertThat(marked()).isEqualTo("box");
        played.keys(Key.TAB);
        assertThat(marked()).isEqualTo("wall");
        played.keys(Key.TAB);
        assertThat(marked()).as("round").isEqualTo("box");
        played.shiftTab();
        assertThat(marked()).as("round and back").isEqualTo("wall");
        played.shiftTab();
        assertThat(marked()).isEqualTo("box");
    }

    @Test
    void shiftTabBeginsAtTheEnd() {
        played.shiftTab();
        assertThat(marked()).isEqualTo("wall");
    }

    @Test
    void whatStaysIsLeftOut() {
        PlayedLevel one = new PlayedLevel(LevelTexts.sound());
        one.keys(Key.TAB, Key.TAB, Key.ENTER);
        assertThat(one.counts()).startsWith("1 click ");
    }

    @Test
    void arrowsGoToTheNearestBoxThatWay() {
        played.keys(Key.LEFT);
        assertThat(marked()).as("the first, where none was chosen").isEqualTo("box");
        played.keys(Key.LEFT);
        assertThat(marked()).as("there is none to the left").isEqualTo("box");
        played.keys(Key.RIGHT);
        assertThat(marked()).isEqualTo("wall");
        played.keys(Key.LEFT);
        assertThat(marked()).isEqualTo("box");
    }

    @Test
    void enterDeletesTheChosenBox() {
        played.keys(Key.TAB, Key.TAB, Key.ENTER);
        assertThat(played.counts()).startsWith("1 click ");
        assertThat(marked()).isEqualTo(NONE);
        played.turns(60).keys(Key.TAB);
        assertThat(marked()).as("the wall is gone").isEqualTo("box");
    }

    @Test
    void enterWithoutAChoiceDoesNothing() {
        played.keys(Key.ENTER);
        assertThat(played.counts()).startsWith("0 clicks ");
    }

    @Test
    void thePointerTakesTheChoiceBack() {
        played.keys(Key.TAB);
        played.scene.pointerMoved(10, 300);
        assertThat(marked()).isEqualTo(NONE);
    }

    @Test
    void duringTheCooldownTheChoiceIsKept() {
        played.keys(Key.TAB, Key.ENTER, Key.TAB).turns(2).keys(Key.ENTER);
        assertThat(played.texts()).contains("wait for the ring");
        assertThat(marked()).isEqualTo("wall");
    }
}
