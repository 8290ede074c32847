package rigibo.lab.ablation;

import rigibo.lab.ablation.probe.Sample;
import rigibo.lab.child.Interval;

import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * Runs made in pairs, at the same time.
 *
 * @param first of each pair: with less in it
 * @param second of each pair
 */
record Pairs(List<Sample> first, List<Sample> second) {

    /** Of the times per step, second over first. */
    Interval ratio() {
        return times((one, other) -> other / one);
    }

    /** ns per step that the second takes longer. */
    Interval difference() {
        return times((one, other) -> other - one);
    }

    /** Per pair, from the times of both. */
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

    /** ns per step of the first. */
    double firstNanos() {
        return median(first, Sample::nanosPerStep);
    }

    /** ns per step of the second. */
    double secondNanos() {
        return median(second, Sample::nanosPerStep);
    }

    private static double median(List<Sample> samples, ToDoubleFunction<Sample> of) {
        return Interval.of(samples.stream().mapToDouble(of).toArray()).median();
    }

    /** The most that a run of either allocated, bytes per step. */
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

    /** Bits per body that the second has more. */
    int addedBits() {
        return second.get(0).bitsPerBody() - first.get(0).bitsPerBody();
    }
}
