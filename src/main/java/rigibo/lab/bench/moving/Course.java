package rigibo.lab.bench.moving;

import rigibo.lab.bench.probe.StepTimes;

import java.util.Arrays;

/**
 * What happened in a scene in one engine, and how long it took.
 *
 * @param nanos processor time of each step, the median of several runs, ns
 * @param contacts of each step; empty if the engine does not report them
 * @param lastMoving the last step after which a body was too fast to count as still; −1 if there is
 *     none
 * @param deepest overlap after any step, in widths of the smaller body
 * @param left overlap after the last step, in the same unit
 * @param gain greatest energy beyond that at the start, as a share of it; NaN if something is
 *     driven
 * @param bytes allocated in a step, median
 * @param jointError the most that a joint was off after any step, m
 */
record Course(
        double[] nanos,
        double[] contacts,
        int lastMoving,
        double deepest,
        double left,
        double gain,
        double bytes,
        double jointError) {

    /** The times of the first steps. */
    StepTimes times(int steps) {
        return new StepTimes(Arrays.copyOf(nanos, Math.min(steps, nanos.length)));
    }

    /**
     * The times of those among the first steps that have at least half of the largest number of
     * contacts: typical steps of a heap.
     */
    StepTimes busyTimes(int steps) {
        int count = Math.min(steps, contacts.length);
        double most = Arrays.stream(contacts, 0, count).max().orElse(0);
        double[] busy = new double[count];
        int found = 0;
        for (int i = 0; i < count; i++) {
            if (contacts[i] >= most / 2) {
                busy[found++] = nanos[i];
            }
        }
        return new StepTimes(Arrays.copyOf(busy, found));
    }
}
