package rigibo.frontend.display;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

/** The clock against a fake time, so that nothing here depends on how fast the machine is. */
class FrameClockTest {

    private static final long SECOND = 1_000_000_000L;

    /** Time that passes by itself a little with every look, and by sleeping. */
    private long now;

    private final FrameClock clock = new FrameClock(() -> now += 1000, nanos -> now += nanos);

    @Test
    void sixHundredTurnsTakeTenSecondsWhereAFrameCostsNothing() {
        long start = now;
        for (int i = 0; i < 600; i++) {
            clock.awaitTurn();
        }
        // Looking at the fake time costs 1 µs, so the last turn may end that much late.
        assertThat((now - start) / (double) SECOND).isCloseTo(10, within(1e-4));
    }

    @Test
    void keepsTheRateOnAMonitorOf144HzThatPacesEveryFrame() {
        long start = now;
        for (int i = 0; i < 600; i++) {
            now += SECOND / 144;
            clock.awaitTurn();
        }
        assertThat((now - start) / (double) SECOND).isCloseTo(10, within(1e-4));
    }

    @Test
    void catchesUpWithOneLateFrameButNeverSkipsASlowStretch() {
        for (int i = 0; i < 60; i++) {
            now += SECOND / 20;
            clock.awaitTurn();
        }
        long start = now;
        for (int i = 0; i < 60; i++) {
            clock.awaitTurn();
        }
        // Three seconds were lost; were they made up for, these turns would take no time at all.
        assertThat((now - start) / (double) SECOND).isCloseTo(1, within(0.02));
    }

    @Test
    void tellsTheShareOfRealTime() {
        for (int i = 0; i < 400; i++) {
            now += SECOND / 30;
            clock.awaitTurn();
        }
        // At 30 turns a second the game runs at half speed; the mean has 400 turns to get there.
        assertThat(clock.pace()).isCloseTo(0.5, within(1e-3));
    }
}
