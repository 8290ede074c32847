package rigibo.frontend.scene.widget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Words;

import java.util.List;

/** A panel at the origin: 12 px of padding, rows of 30 px. */
class PanelTest {

    private static final double WIDTH = 224;

    private double number = 5;
    private boolean isOn;
    private int pressed;

    private final Panel panel =
            new Panel(
                    0,
                    0,
                    WIDTH,
                    List.of(
                            new Readout("read", () -> "1 m"),
                            new Slider(
                                    new Words("en"),
                                    "menu.play",
                                    "%.0f",
                                    0,
                                    10,
                                    1,
                                    () -> number,
                                    v -> number = v),
                            new Toggle("flip", () -> isOn, () -> isOn = !isOn),
                            new Button("press", () -> pressed++)));

    @Test
    void dragsASliderToWhereThePointerIs() {
        panel.pointerPressed(12 + 0.3 * 200, 12 + 30 + 15);
        assertThat(number).isEqualTo(3);
        panel.pointerMoved(12 + 0.8 * 200, 500);
        assertThat(number).isEqualTo(8);
        panel.pointerReleased();
        panel.pointerMoved(12, 500);
        assertThat(number).isEqualTo(8);
    }

    @Test
    void keepsASliderWithinItsBounds() {
        panel.pointerPressed(12, 12 + 30 + 15);
        panel.pointerMoved(-900, 0);
        assertThat(number).isCloseTo(0, within(1e-12));
        panel.pointerMoved(900, 0);
        assertThat(number).isCloseTo(10, within(1e-12));
    }

    @Test
    void isUsedByKeysAlone() {
        panel.keyPressed(Key.DOWN);
        panel.keyPressed(Key.RIGHT);
        assertThat(number).as("the readout is passed over").isEqualTo(6);
        panel.keyPressed(Key.DOWN);
        panel.keyPressed(Key.ENTER);
        assertThat(isOn).isTrue();
        panel.keyPressed(Key.DOWN);
        panel.keyPressed(Key.ENTER);
        assertThat(pressed).isEqualTo(1);
    }

    @Test
    void tellsWhetherAClickWasItsOwn() {
        assertThat(panel.pointerPressed(100, 12 + 3 * 30 + 15)).isTrue();
        assertThat(pressed).isEqualTo(1);
        assertThat(panel.pointerPressed(WIDTH + 1, 20)).isFalse();
    }
}
