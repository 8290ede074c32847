package rigibo.frontend.scene.accuracy;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;

class BadgeTest {

    /** Width from the end of the dial to the end of the bar, px. */
    private static final double ROOM = Scene.WIDTH - 8 - (8 + 5 + Dial.width(Layout.ALONE) + 9);

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void theLongestNumbersFitBesideTheDial(String language) {
        Badge badge = new Badge(new Words(language));
        String longest =
                String.join(
                        " · ",
                        badge.step(0.44e6),
                        badge.price(4.4),
                        badge.error(4e-12),
                        badge.pace(0.44));
        double width = new RecordingCanvas().textWidth(longest, 16, Canvas.Font.WORDS);
        assertThat(width).as(longest).isLessThan(ROOM);
    }
}
