package rigibo.frontend.display;

import java.util.concurrent.locks.LockSupport;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;

/**
 * Paces the loop by its own clock, since vsync is unreliable: a monitor may run at 144 Hz and a
 * driver may ignore it. A step is due 60 times a second, and each turn of the loop waits for one.
 * After a late frame a turn makes up to four steps, so that the world keeps real time. Steps that
 * one more such turn cannot catch up are dropped, and so are those due while steps take longer than
 * the time that they simulate: the world then slows down, but turns do not grow ever longer. The
 * length of a step never changes.
 */
final class FrameClock {

    /** Steps per second, and turns where pictures are in time. */
    static final int RATE = 60;

    /** Steps in a turn at most: with more, what is clicked would be answered too late. */
    static final int MOST_STEPS = 4;

    private static final long SECOND = 1_000_000_000;
    private static final double PERIOD_NANOS = (double) SECOND / RATE;

    /** What sleeping may overshoot by, ns; the rest is waited awake. */
    private static final long SLEEP_SLACK = 1_500_000;

    /**
     * How late a turn may come without its lateness being made up for, as a share of a step: 0.5 %.
     * A monitor of 59.94 Hz would else be given two steps in one picture every 16 seconds, a jolt.
     */
    private static final long FORGIVEN = SECOND / RATE / 200;

    /** Over how many turns the rate is averaged. */
    private static final double SMOOTHING = 30;

    /** What one turn counts for in the average at most, ns: a game that was stopped is not slow. */
    private static final double LONGEST = SECOND;

    private final LongSupplier nanoseconds;
    private final LongConsumer sleep;

    /** Steps are due from here on, ns; counted, not added up, so that nothing drifts. */
    private long origin;

    private long stepsSinceOrigin;

    /** When this turn began, ns, and its steps so far. */
    private long turn;

    private int stepsInTurn;

    /** Real time that the world was not given in this turn, ns. */
    private long dropped;

    private double meanDropped;
    private double meanTurn;

    /** A clock on the system's time. */
    FrameClock() {
        this(System::nanoTime, LockSupport::parkNanos);
    }

    /** A clock on any time in ns, with a way to sleep some ns. */
    FrameClock(LongSupplier nanoseconds, LongConsumer sleep) {
        this.nanoseconds = nanoseconds;
        this.sleep = sleep;
        meanTurn = PERIOD_NANOS;
        restart();
    }

    /** Begins anew: a step is due now, and what was due before is forgotten. */
    void restart() {
        turn = nanoseconds.getAsLong();
        origin = turn;
        stepsSinceOrigin = 0;
        stepsInTurn = 0;
        dropped = 0;
    }

    /** Waits until the next turn is due, and begins it. */
    void awaitTurn() {
        long due = due();
        long now = nanoseconds.getAsLong();
        if (now >= due) {
            forgive(now - due);
        }
        while (now < due) {
            long left = due - now;
            if (left > SLEEP_SLACK) {
                sleep.accept(left - SLEEP_SLACK);
            } else {
                Thread.onSpinWait();
            }
            now = nanoseconds.getAsLong();
        }
        average(now - turn);
        turn = now;
        stepsInTurn = 0;
    }

    /** When the next step is due. */
    private long due() {
        return origin + stepsSinceOrigin * SECOND / RATE;
    }

    /** A monitor that is a hair slower than we are sets the pace. */
    private void forgive(long late) {
        if (late < PERIOD_NANOS) {
            postpone(Math.min(late, FORGIVEN));
        }
    }

    private void postpone(long nanos) {
        origin += nanos;
        dropped += nanos;
    }

    private void average(long nanos) {
        meanTurn += (Math.min(nanos, LONGEST) - meanTurn) / SMOOTHING;
        meanDropped += (Math.min(dropped, LONGEST - PERIOD_NANOS) - meanDropped) / SMOOTHING;
        dropped = 0;
    }

    /**
     * Counts a step that was made, and tells whether this turn is to make another. What is due and
     * does not fit is left to the next turn where that could make up for it, and else dropped.
     *
     * @param most steps in a turn, 1 to {@link #MOST_STEPS}
     */
    boolean isAnotherDueOf(int most) {
        stepsSinceOrigin++;
        stepsInTurn++;
        long late = turn - due();
        if (late < 0) {
            return false;
        }
        boolean keepsUp = keepsUp();
        boolean isAnother = keepsUp && stepsInTurn < most;
        if (!isAnother && (!keepsUp || late > most * PERIOD_NANOS)) {
            postpone(late + SECOND / RATE);
        }
        return isAnother;
    }

    /** Whether the steps of this turn took less time than they stand for. */
    private boolean keepsUp() {
        return nanoseconds.getAsLong() - turn <= stepsInTurn * PERIOD_NANOS;
    }

    /** Share of real time the game runs at: 1, or less where time was dropped. */
    double pace() {
        return 1 - meanDropped / meanTurn;
    }
}
