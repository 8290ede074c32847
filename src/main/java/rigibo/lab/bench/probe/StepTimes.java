package rigibo.lab.bench.probe;

import java.util.Arrays;
import java.util.stream.DoubleStream;

/** Times or allocated bytes of one or more steps. */
public final class StepTimes {

    private final double[] sorted;

    /** Takes the values of the steps, in any order. */
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

    /** The 99th percentile; the greatest value if there are fewer than 100. */
    public double p99() {
        return percentile(99);
    }

    public double max() {
        return sorted[sorted.length - 1];
    }

    /**
     * A percentile by the nearest rank: the smallest value that is at least as large as that share
     * of all values.
     */
    private double percentile(int percent) {
        return sorted[(percent * sorted.length + 99) / 100 - 1];
    }
}
