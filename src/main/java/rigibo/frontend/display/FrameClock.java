package rigibo.frontend.display;

import java.util.concurrent.locks.LockSupport;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;

/**
 * Paces the loop to 60 turns a second by a clock of our own: vsync is no clock, a monitor may run
 * at 144 Hz and a driver may ignore it. A turn that comes late moves all later ones: the game runs
 * slower then, it never skips a step.
 */
final class FrameClock {

    /** Turns per second. */
    static final int RATE = 60;

    private static final double PERIOD_NANOS = 1e9 / RATE;

    /** What sleeping may overshoot by, ns; the rest is waited awake. */
    private static final long SLEEP_SLACK = 1_500_000;

    /** Over how many turns the rate is averaged. */
    private static final double SMOOTHING = 30;

    private final LongSupplier nanoseconds;
    private final LongConsumer sleep;
    private double next;
    private double meanPeriod = PERIOD_NANOS;
    private long last;

    /** A clock on the system's time. */
    FrameClock() {
        this(System::nanoTime, LockSupport::parkNanos);
    }

    /** A clock on any time in ns, with a way to sleep some ns. */
    FrameClock(LongSupplier nanoseconds, LongConsumer sleep) {
        this.nanoseconds = nanoseconds;
        this.sleep = sleep;
        last = nanoseconds.getAsLong();
        next = last;
    }

    /** Waits until the next turn is due. */
    void awaitTurn() {
        next += PERIOD_NANOS;
        long now = nanoseconds.getAsLong();
        while (now < next) {
            long left = (long) (next - now);
            if (left > SLEEP_SLACK) {
                sleep.accept(left - SLEEP_SLACK);
            } else {
                Thread.onSpinWait();
            }
            now = nanoseconds.getAsLong();
        }
        if (now - next > PERIOD_NANOS) {
            next = now;
        }
        meanPeriod += (now - last - meanPeriod) / SMOOTHING;
        last = now;
    }

    /** Share of real time the game runs at: 1, or less where turns come late. */
    double pace() {
        return Math.min(1, PERIOD_NANOS / meanPeriod);
    }
}
