package rigibo.lab.ablation;

import rigibo.lab.ablation.probe.Sample;
import rigibo.lab.child.Interval;

import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Samples of runs that were made in pairs.
 *
 * @param first of each pair, the one with less
 * @param second of each pair
 */
record Pairs(List<Sample> first, List<Sample> second) {

    /** The ratio of the times per step, second over first. */
    Interval ratio() {
        return times((one, other) -> other / one);
    }

    /** The difference of the times per step, second minus first, ns. */
    Interval difference() {
        return times((one, other) -> other - one);
    }

    /** A function of the two times of each pair. */
    Interval times(DoubleBinaryOperator operator) {
        return Interval.of(
                IntStream.range(0, first.size())
                        .mapToDouble(
                                i ->
                                        operator.applyAsDouble(
                                                first.get(i).nanosPerStep(),
                                                second.get(i).nanosPerStep()))
                        .toArray());
    }

    /** The median time per step of the first, ns. */
    double firstNanos() {
        return median(first, Sample::nanosPerStep);
    }

    /** The median time per step of the second, ns. */
    double secondNanos() {
        return median(second, Sample::nanosPerStep);
    }

    private static double median(List<Sample> samples, ToDoubleFunction<Sample> of) {
        return Interval.of(samples.stream().mapToDouble(of).toArray()).median();
    }

    /** The most bytes per step that a run of either allocated. */
    double mostBytes() {
        return all().mapToDouble(Sample::bytesPerStep).max().orElse(Double.NaN);
    }

    /** Whether every run ended in the same bits. */
    boolean haveEqualBits() {
        return all().map(Sample::stateHash).distinct().count() == 1;
    }

    /** Whether every run did the same work. */
    boolean haveEqualWork() {
        return all().map(Sample::work).distinct().count() == 1;
    }

    private Stream<Sample> all() {
        return Stream.concat(first.stream(), second.stream());
    }

    /** The bits per body that the second has in addition. */
    int addedBits() {
        return second.get(0).bitsPerBody() - first.get(0).bitsPerBody();
    }
}
