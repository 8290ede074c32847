package rigibo.frontend.display;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.KeyBindings;
import rigibo.frontend.scene.PointerButton;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Tap;

import java.util.ArrayList;
import java.util.List;

class FingerTest {

    private final List<String> told = new ArrayList<>();
    private Tap tap = Tap.AT_ONCE;
    private double now;

    private final Scene scene =
            new BlankScene() {
                @Override
                public Tap tap(double x, double y) {
                    return tap;
                }

                @Override
                public void choosing(boolean isChoosing) {
                    told.add(isChoosing ? "choosing" : "chosen");
                }

                @Override
                public void pointerMoved(double x, double y) {
                    told.add(x < 0 ? "away" : "at " + Math.round(x));
                }

                @Override
                public void pointerPressed(PointerButton button, double x, double y) {
                    told.add("press " + name(button) + Math.round(x));
                }

                @Override
                public void pointerReleased(PointerButton button, double x, double y) {
                    told.add(("release " + name(button)).trim());
                }
            };

    private static String name(PointerButton button) {
        return button == PointerButton.RIGHT ? "right " : "";
    }

    private final Finger finger =
            new Finger(
                    new Input(
                            scene, () -> {}, () -> {}, () -> {}, () -> {}, () -> KeyBindings.FIRST),
                    () -> now);

    @Test
    void dragsAtOnceWhatIsDragged() {
        finger.down(10, 10);
        finger.slid(60, 10);
        finger.lifted();
        assertThat(told).containsExactly("at 10", "press 10", "at 60", "chosen", "release", "away");
    }

    @Test
    void aButtonIsPressedAsTheFingerIsLifted() {
        tap = Tap.LIFTED;
        finger.down(10, 10);
        assertThat(told).containsExactly("at 10");
        finger.slid(20, 10);
        now += 0.3;
        finger.lifted();
        assertThat(told).contains("press 20");
    }

    @Test
    void aFingerThatSlidOffAButtonDoesNotMeanIt() {
        tap = Tap.LIFTED;
        finger.down(10, 10);
        finger.slid(40, 10);
        finger.slid(10, 10);
        finger.lifted();
        assertThat(told).contains("away").noneMatch(it -> it.startsWith("press"));
    }

    @Test
    void aFingerThatRestsOnAButtonOnlyLooks() {
        tap = Tap.LIFTED;
        finger.down(10, 10);
        now += 1;
        finger.lifted();
        assertThat(told).contains("at 10").noneMatch(it -> it.startsWith("press"));
    }

    @Test
    void whatIsChosenIsPressedWhereTheFingerIsLiftedHoweverLongItTook() {
        tap = Tap.CHOSEN;
        finger.down(10, 10);
        finger.slid(200, 10);
        now += 5;
        finger.lifted();
        assertThat(told)
                .containsExactly(
                        "at 10",
                        "choosing",
                        "at 200",
                        "choosing",
                        "press 200",
                        "chosen",
                        "release",
                        "away");
    }

    @Test
    void aFingerThatRestsOnNothingIsTheOtherButton() {
        tap = Tap.RESTED;
        finger.down(10, 10);
        finger.slid(15, 10);
        finger.turn(0.5);
        assertThat(told).noneMatch(it -> it.startsWith("press"));
        finger.turn(1);
        finger.turn(2);
        finger.slid(200, 10);
        finger.lifted();
        assertThat(told)
                .containsExactly(
                        "at 10",
                        "at 15",
                        "press right 15",
                        "at 200",
                        "chosen",
                        "release right",
                        "away");
    }

    @Test
    void aFingerThatSlidOrWasLiftedInTimeIsNot() {
        tap = Tap.RESTED;
        finger.down(10, 10);
        finger.slid(60, 10);
        finger.turn(1);
        finger.lifted();
        now = 2;
        finger.down(10, 10);
        now = 2.3;
        finger.lifted();
        finger.turn(4);
        assertThat(told).noneMatch(it -> it.startsWith("press"));
    }

    @Test
    void whatTheSystemTakesPressesNothing() {
        tap = Tap.CHOSEN;
        finger.down(10, 10);
        finger.taken();
        finger.lifted();
        assertThat(told).contains("chosen", "away").noneMatch(it -> it.startsWith("press"));
    }
}
