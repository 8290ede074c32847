package rigibo.frontend.display;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Camera;
import rigibo.frontend.scene.Edges;
import rigibo.frontend.scene.KeyBindings;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Pinch;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Tap;
import rigibo.frontend.scene.widget.Plate;

import java.util.ArrayList;
import java.util.List;

class FingersTest {

    private static final Layout PHONE = Layout.inHand(390, 844, 1, Edges.NONE);
    private static final int THUMB = 7;
    private static final int INDEX = 8;
    private static final int THIRD = 9;

    private final List<String> told = new ArrayList<>();
    private final Camera camera = Camera.ofPuzzle();
    private Tap tap = Tap.AT_ONCE;

    private final Scene scene =
            new BlankScene() {
                @Override
                public Tap tap(double x, double y) {
                    return tap;
                }

                @Override
                public void pointerPressed(PointerButton button, double x, double y) {
                    told.add("pressed");
                }

                @Override
                public void pointerReleased(PointerButton button, double x, double y) {
                    told.add("released");
                }

                @Override
                public void interrupted() {
                    told.add("interrupted");
                }

                @Override
                public void pinched(Pinch pinch) {
                    told.add("pinched");
                    camera.pinch(pinch);
                }
            };

    private final Input input =
            new Input(scene, () -> {}, () -> {}, () -> {}, () -> {}, () -> KeyBindings.FIRST);
    private final Fingers fingers = new Fingers(input, () -> 0);

    /** Where in the world a point of the phone's screen is now, m. */
    private double worldX(double x) {
        return camera.worldX(PHONE.logicalX(x));
    }

    private double worldY(double y) {
        return camera.worldY(PHONE.logicalY(y));
    }

    /** Two fingers in line with what they meant at first keep it, however they move. */
    @Test
    void whatIsUnderTwoFingersStaysThere() {
        input.shows(PHONE, 1, Plate.NONE);
        double thumbX = worldX(100);
        double thumbY = worldY(500);
        double indexX = worldX(160);
        double indexY = worldY(420);
        fingers.down(THUMB, 100, 500);
        fingers.down(INDEX, 160, 420);
        // The fingers move, and part to twice their distance without turning.
        for (int i = 1; i <= 20; i++) {
            fingers.slid(THUMB, 100 - 2 * i, 500 + 5 * i);
            fingers.slid(INDEX, 160 + i, 420 + i);
        }
        assertThat(worldX(60)).isCloseTo(thumbX, within(1e-9));
        assertThat(worldY(600)).isCloseTo(thumbY, within(1e-9));
        assertThat(worldX(180)).isCloseTo(indexX, within(1e-9));
        assertThat(worldY(440)).isCloseTo(indexY, within(1e-9));
        assertThat(camera.scale()).isCloseTo(2 * Camera.DEFAULT_SCALE, within(1e-9));
    }

    @Test
    void aSecondFingerGivesUpWhatTheFirstBegan() {
        fingers.down(THUMB, 100, 100);
        fingers.down(INDEX, 200, 100);
        fingers.lifted(THUMB);
        fingers.slid(INDEX, 300, 100);
        fingers.lifted(INDEX);
        assertThat(told).containsExactly("pressed", "interrupted", "released");
    }

    @Test
    void nothingIsChosenByTwoFingersAndTheNextOneAloneChoosesAgain() {
        tap = Tap.CHOSEN;
        fingers.down(THUMB, 100, 100);
        fingers.down(INDEX, 200, 100);
        fingers.lifted(INDEX);
        fingers.lifted(THUMB);
        assertThat(told).doesNotContain("pressed");
        fingers.down(THIRD, 100, 100);
        fingers.lifted(THIRD);
        assertThat(told).contains("pressed");
    }

    /** A palm, or the edge of a thumb, that comes to rest beside two fingers. */
    @Test
    void aThirdFingerChangesNothing() {
        fingers.down(THUMB, 100, 100);
        fingers.down(INDEX, 200, 100);
        fingers.down(THIRD, 300, 300);
        fingers.slid(THIRD, 350, 300);
        assertThat(told).doesNotContain("pinched");
        fingers.slid(INDEX, 210, 100);
        assertThat(told).contains("pinched");
    }

    @Test
    void fingersThatMeetAreNoEndlessEnlargement() {
        fingers.down(THUMB, 100, 100);
        fingers.down(INDEX, 100, 100);
        fingers.slid(INDEX, 101, 100);
        assertThat(camera.scale()).isEqualTo(Camera.DEFAULT_SCALE);
    }
}
