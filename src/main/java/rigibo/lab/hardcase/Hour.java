package rigibo.lab.hardcase;

/**
 * An hour of simulated time. Truth: once warm, a step takes nothing from the heap, and the last
 * minute works no more than the second. What a step takes it takes in every minute, so the least
 * minute tells: the virtual machine makes the texts of a class on the thread that runs, whenever it
 * hands one of its methods to the optimizing compiler. What counts here is work and not time, which
 * is the machine's.
 */
final class Hour {

    static final int STEPS = 216_000;

    private static final int MINUTES = 60;
    private static final int STEPS_A_MINUTE = STEPS / MINUTES;

    /** From then on the heap is watched. */
    private static final int WARM = MINUTES / 2;

    /** A scene on its way through many places does not do the same in every minute. */
    private static final double MOST_GROWTH = 0.01;

    private final Trial trial;
    private final WatchedPool pool;
    private long workBefore;

    Hour(Trial trial, WatchedPool pool) {
        this.trial = trial;
        this.pool = pool;
    }

    /** Runs the hour and asks the judge after every minute. */
    void run(Runnable judge) {
        long second = 0;
        long last = 0;
        long least = Long.MAX_VALUE;
        for (int minute = 1; minute <= MINUTES; minute++) {
            long before = pool.allocated();
            last = workOfMinute();
            judge.run();
            if (minute == 2) {
                second = last;
            } else if (minute > WARM) {
                least = Math.min(least, pool.allocated() - before);
            }
        }
        double bytes = least / (double) STEPS_A_MINUTE;
        trial.measure("taken from the heap", bytes, "B/step", 0);
        double growth = Math.max(last / (double) second - 1, 0);
        trial.measure("growth of the work", growth, "of it", MOST_GROWTH);
    }

    private long workOfMinute() {
        for (int i = 0; i < STEPS_A_MINUTE; i++) {
            pool.step();
        }
        Work work = trial.work();
        long sum = work.pairs() + work.impacts() + work.evaluations() + work.rows();
        long ofMinute = sum - workBefore;
        workBefore = sum;
        return ofMinute;
    }
}
