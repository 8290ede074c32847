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

    /** Steps per second; also turns per second while no frame is late. */
    static final int RATE = 60;

    /** Most steps of a turn; with more, clicks would be answered too late. */
    static final int MOST_STEPS = 4;

    private static final long SECOND = 1_000_000_000;
    private static final double PERIOD_NANOS = (double) SECOND / RATE;

    /** Time by which sleeping may overshoot, ns; the clock spins for that rest. */
    private static final long SLEEP_SLACK = 1_500_000;

    /**
     * Lateness of a turn that is not made up for, as a share of a step: 0.5 %. Otherwise a monitor
     * of 59.94 Hz would show two steps in one frame every 16 seconds, which is seen as a jolt.
     */
    private static final long FORGIVEN = SECOND / RATE / 200;

    /** Number of turns over which the rate is averaged. */
    private static final double SMOOTHING = 30;

    /** Longest time of one turn in the average, ns: a game that was stopped is not slow. */
    private static final double LONGEST = SECOND;

    private final LongSupplier nanoseconds;
    private final LongConsumer sleep;

    /**
     * Time from which steps are due, ns. Due times are multiples of a step after it, so that no
     * error adds up.
     */
    private long origin;

    private long stepsSinceOrigin;

    /** When this turn began, ns, and its steps so far. */
    private long turn;

    private int stepsInTurn;

    /** Real time that this turn did not simulate, ns. */
    private long dropped;

    private double meanDropped;
    private double meanTurn;

    /** A clock that uses the system's time. */
    FrameClock() {
        this(System::nanoTime, LockSupport::parkNanos);
    }

    /** A clock that uses a given time, ns, and a way to sleep for some ns. */
    FrameClock(LongSupplier nanoseconds, LongConsumer sleep) {
        this.nanoseconds = nanoseconds;
        this.sleep = sleep;
        meanTurn = PERIOD_NANOS;
        restart();
    }

    /** Begins anew: one step is due now, and the backlog is forgotten. */
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
        begin(now);
    }

    /**
     * Begins the next turn if it is due within half a step, for whoever is called at each picture
     * of a monitor and cannot wait.
     *
     * @return whether it began
     */
    boolean beginsTurn() {
        long now = nanoseconds.getAsLong();
        if (now + SECOND / RATE / 2 < due()) {
            return false;
        }
        begin(now);
        return true;
    }

    private void begin(long now) {
        average(now - turn);
        turn = now;
        stepsInTurn = 0;
    }

    /** When the next step is due. */
    private long due() {
        return origin + stepsSinceOrigin * SECOND / RATE;
    }

    /** Lets a monitor that is slightly slower than the clock set the pace. */
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
     * Counts a step that was made, and returns whether this turn is to make another. Due steps that
     * do not fit are left to the next turn if that can catch up, and are dropped otherwise.
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

    /** Whether the steps of this turn took less time than they simulate. */
    private boolean keepsUp() {
        return nanoseconds.getAsLong() - turn <= stepsInTurn * PERIOD_NANOS;
    }

    /** Share of real time at which the game runs: 1, or less if time was dropped. */
    double pace() {
        return 1 - meanDropped / meanTurn;
    }
}
