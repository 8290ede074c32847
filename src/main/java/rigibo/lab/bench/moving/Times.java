package rigibo.lab.bench.moving;

import java.util.Arrays;
import java.util.stream.DoubleStream;

/** Times of steps, ns, one at least. */
final class Times {

    private final double[] sorted;

    Times(double[] nanos) {
        sorted = nanos.clone();
        Arrays.sort(sorted);
    }

    double mean() {
        return DoubleStream.of(sorted).average().orElseThrow();
    }

    double max() {
        return sorted[sorted.length - 1];
    }

    /** The least that is no less than so many % of all, by the nearest rank. */
    double percentile(int percent) {
        return sorted[(percent * sorted.length + 99) / 100 - 1];
    }
}
