package rigibo.frontend.puzzle.rules;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class HoldClockTest {

    private static final int HOLD = 180;
    private static final int GRACE = 15;

    private final HoldClock clock = new HoldClock(HOLD, GRACE);

    private void observe(int from, int to, boolean touches) {
        for (int now = from; now <= to; now++) {
            clock.observe(now, touches);
        }
    }

    @Test
    void isHeldExactlyWhenTheHoldHasPassedSinceTheFirstTouch() {
        observe(10, 189, true);
        assertThat(clock.isHeld(189)).isFalse();
        observe(190, 190, true);
        assertThat(clock.isHeld(190)).isTrue();
    }

    @Test
    void aBounceShorterThanTheGraceGoesOnCounting() {
        observe(10, 100, true);
        observe(101, 114, false);
        observe(115, 190, true);
        assertThat(clock.isHeld(190)).isTrue();
    }

    @Test
    void aBounceAsLongAsTheGraceBeginsAnew() {
        observe(10, 100, true);
        observe(101, 115, false);
        assertThat(clock.fraction(115)).isZero();
        observe(116, 295, true);
        assertThat(clock.isHeld(295)).isFalse();
        observe(296, 296, true);
        assertThat(clock.isHeld(296)).isTrue();
    }

    @Test
    void neverRunsOutInTheAir() {
        observe(10, 185, true);
        observe(186, 195, false);
        assertThat(clock.isHeld(195)).isFalse();
        observe(196, 196, true);
        assertThat(clock.isHeld(196)).isTrue();
    }

    @Test
    void withoutGraceOneStepApartBeginsAnew() {
        HoldClock strict = new HoldClock(2, 0);
        strict.observe(1, true);
        strict.observe(2, true);
        assertThat(strict.fraction(2)).isEqualTo(0.5);
        strict.observe(3, false);
        strict.observe(4, true);
        assertThat(strict.fraction(4)).isZero();
    }
}
