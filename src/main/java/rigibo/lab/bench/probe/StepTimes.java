package rigibo.lab.bench.probe;

import java.util.Arrays;

/** What each of a number of steps took or allocated, in the order in which they were made. */
final class StepTimes {

    private final double[] values;
    private int count;

    StepTimes(int most) {
        values = new double[most];
    }

    void add(double value) {
        values[count] = value;
        count++;
    }

    /**
     * The least value that is no less than a share of all values, by the nearest rank: of fewer
     * than 100 values the 99th percentile is the greatest.
     *
     * @param percent above 0, up to 100
     */
    double percentile(int percent) {
        double[] sorted = Arrays.copyOf(values, count);
        Arrays.sort(sorted);
        int rank = (percent * count + 99) / 100;
        return sorted[rank - 1];
    }
}
