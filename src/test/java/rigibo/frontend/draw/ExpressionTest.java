package rigibo.frontend.draw;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.Canvas.Mood;

class ExpressionTest {

    private static final double FRAME = 1.0 / 60;

    private static boolean isBlinking(int number, double seconds) {
        return Expression.of(Mood.PLAIN, number, seconds) == Expression.BLINKING;
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 7, 49})
    void blinksNowAndThen(int number) {
        int closed = 0;
        for (int frame = 0; frame < 60 * 60; frame++) {
            closed += isBlinking(number, frame * FRAME) ? 1 : 0;
        }
        // Once or twice for 0.12 s in every 2.8 s to 5.7 s: 2 % to 9 % of the time.
        assertThat(closed / 3600.0).isBetween(0.02, 0.09);
    }

    @Test
    void noTwoOfAStackBlinkTogether() {
        for (int frame = 0; frame < 600; frame++) {
            int closed = 0;
            for (int number = 0; number < 6; number++) {
                closed += isBlinking(number, frame * FRAME) ? 1 : 0;
            }
            assertThat(closed).as("frame %d", frame).isLessThan(4);
        }
    }

    @Test
    void wincesWhateverTheTimeAndSleepsThroughBlinks() {
        for (int frame = 0; frame < 600; frame++) {
            double seconds = frame * FRAME;
            assertThat(Expression.of(Mood.HOVERED, 3, seconds)).isEqualTo(Expression.WINCING);
            assertThat(Expression.of(Mood.ASLEEP, 3, seconds)).isEqualTo(Expression.ASLEEP);
        }
    }

    @Test
    void pupilsShowOnlyInOpenEyes() {
        assertThat(Expression.CALM.isOpen()).isTrue();
        assertThat(Expression.BLINKING.isOpen()).isFalse();
        assertThat(Expression.WINCING.isOpen()).isFalse();
    }
}
