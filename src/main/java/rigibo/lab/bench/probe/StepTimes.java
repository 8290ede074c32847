package rigibo.lab.bench.probe;

import java.util.Arrays;
import java.util.stream.DoubleStream;

/** What each of a number of steps took or allocated; one step at least. */
public final class StepTimes {

    private final double[] sorted;

    /** Values of steps in any order. */
    public StepTimes(double[] values) {
        sorted = values.clone();
        Arrays.sort(sorted);
    }

    public double mean() {
        return DoubleStream.of(sorted).average().orElseThrow();
    }

    public double median() {
        return percentile(50);
    }

    /** The 99th percentile: of fewer than 100 values the greatest. */
    public double p99() {
        return percentile(99);
    }

    public double max() {
        return sorted[sorted.length - 1];
    }

    /** The least value that is no less than a share of all values, by the nearest rank. */
    private double percentile(int percent) {
        return sorted[(percent * sorted.length + 99) / 100 - 1];
    }
}
