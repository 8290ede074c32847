package rigibo.lab;

import rigibo.backend.Pool;

import java.util.Arrays;

/**
 * The time of a step of the flood while its discs fall and settle, without friction, in a trough of
 * 40 m.
 *
 * @param bodies discs
 * @param medianMillis median time of a step, ms
 * @param p99Millis 99th percentile, ms
 * @param deepestOverlap at the end, m: a run that is fast because discs sink is worthless
 */
public record FloodTiming(
        int bodies, double medianMillis, double p99Millis, double deepestOverlap) {

    private static final Flood TROUGH = new Flood(40, 0.25);
    private static final int WARM_STEPS = 300;
    private static final int TIMED_STEPS = 900;

    /** Runs the flood with this many discs. */
    public static FloodTiming measure(int bodies) {
        Pool pool = TROUGH.pour(bodies, Flood.FRICTIONLESS, 0);
        double[] millis = new double[TIMED_STEPS];
        for (int i = -WARM_STEPS; i < TIMED_STEPS; i++) {
            long before = System.nanoTime();
            pool.step(Flood.STEP);
            if (i >= 0) {
                millis[i] = (System.nanoTime() - before) / 1e6;
            }
        }
        Arrays.sort(millis);
        return new FloodTiming(
                bodies,
                millis[TIMED_STEPS / 2],
                millis[TIMED_STEPS * 99 / 100],
                pool.report().deepestOverlap());
    }
}
