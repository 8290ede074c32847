package rigibo.lab.hardcase;

import rigibo.lab.child.Work;

/**
 * An hour of simulated time. Truth: once warm, a step allocates nothing, and the last minute takes
 * no more work than the second. Work is counted, since time depends on the machine.
 */
final class Hour {

    static final int STEPS = 216_000;

    private static final int STEPS_A_MINUTE = STEPS / 60;

    /** The growth of work that is allowed, since a moving scene varies from minute to minute. */
    private static final double MOST_GROWTH = 0.01;

    private final Trial trial;
    private final WatchedPool pool;
    private long workBefore;

    Hour(Trial trial, WatchedPool pool) {
        this.trial = trial;
        this.pool = pool;
    }

    /** Runs the hour and calls the judge after every minute. */
    void run(Runnable judge) {
        long second = 0;
        long warm = 0;
        long last = 0;
        for (int minute = 1; minute <= STEPS / STEPS_A_MINUTE; minute++) {
            last = workOfMinute();
            judge.run();
            if (minute == 1) {
                warm = pool.allocated();
            } else if (minute == 2) {
                second = last;
            }
        }
        double bytes = (pool.allocated() - warm) / (double) (STEPS - STEPS_A_MINUTE);
        trial.measure("taken from the heap", bytes, "B/step", 0);
        double growth = Math.max(last / (double) second - 1, 0);
        trial.measure("growth of the work", growth, "of it", MOST_GROWTH);
    }

    private long workOfMinute() {
        for (int i = 0; i < STEPS_A_MINUTE; i++) {
            pool.step();
        }
        Work work = trial.work().all();
        long sum = work.pairs() + work.solved();
        long ofMinute = sum - workBefore;
        workBefore = sum;
        return ofMinute;
    }
}
