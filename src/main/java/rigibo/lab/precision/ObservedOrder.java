package rigibo.lab.precision;

import rigibo.lab.engine.Line;

import java.util.Comparator;
import java.util.List;
import java.util.OptionalInt;
import java.util.stream.IntStream;

/**
 * The observed order of convergence along a line: the median of p = log(e_h/e_k)/log(h/k) over all
 * pairs of neighbouring steps h and k = h/2 (P. J. Roache, "Verification and Validation in
 * Computational Science and Engineering", 1998, section 5.4).
 *
 * @param pairs whose errors are both above those of rounding
 * @param median over the pairs; NaN where there are fewer than two
 * @param least over the pairs
 * @param greatest over the pairs
 */
record ObservedOrder(int pairs, double median, double least, double greatest) {

    /** The largest error that rounding explains: some thousand steps of 2⁻⁵³ each. */
    static final double ROUND_OFF = 1e-12;

    private static final int LEAST_PAIRS = 2;

    /** The distance from a whole number within which an order counts as that number. */
    private static final double CLOSE = 0.25;

    /** The spread of the orders of single pairs beyond which there is no order. */
    private static final double IRREGULAR = 2;

    /** The verdict on an order. */
    enum Verdict {
        /** The order of the method. */
        AS_EXPECTED,
        HIGHER,
        LOWER,
        /** An order along a line whose method promises none. */
        SOME,
        /** The error does not depend on the step. */
        FLAT,
        /** The error grows as the step shrinks. */
        RISING,
        IRREGULAR,
        /** Nothing is left but rounding. */
        EXACT,
        NOT_KNOWN
    }

    /** The order of a line's points, in any order; failed points are ignored. */
    static ObservedOrder of(List<Point> line) {
        List<Point> sorted =
                line.stream()
                        .filter(point -> !point.errors().hasFailed())
                        .sorted(Comparator.comparingDouble(point -> -point.setting().step()))
                        .toList();
        double[] orders =
                IntStream.range(1, sorted.size())
                        .filter(i -> sorted.get(i).errors().main() > ROUND_OFF)
                        .filter(i -> sorted.get(i - 1).errors().main() > ROUND_OFF)
                        .mapToDouble(i -> order(sorted.get(i - 1), sorted.get(i)))
                        .sorted()
                        .toArray();
        int n = orders.length;
        return n < LEAST_PAIRS
                ? new ObservedOrder(n, Double.NaN, Double.NaN, Double.NaN)
                : new ObservedOrder(
                        n, (orders[(n - 1) / 2] + orders[n / 2]) / 2, orders[0], orders[n - 1]);
    }

    private static double order(Point coarse, Point fine) {
        double errors = coarse.errors().main() / fine.errors().main();
        return Math.log(errors) / Math.log(coarse.setting().step() / fine.setting().step());
    }

    /** Whether only the step varies along a line. */
    static boolean isObservedOf(Line line) {
        return line.unit().equals("s");
    }

    boolean isKnown() {
        return !Double.isNaN(median);
    }

    /** The order that a line's method promises; empty if it promises none. */
    static OptionalInt expected(Line line) {
        return switch (line) {
            case STEP_EULER -> OptionalInt.of(1);
            case STEP_VERLET -> OptionalInt.of(2);
            case STEP_RK4 -> OptionalInt.of(4);
            case STEP_DISCRETE -> OptionalInt.of(1);
            default -> OptionalInt.empty();
        };
    }

    /** The verdict on a line with these points. */
    Verdict verdict(Line line, List<Point> points) {
        if (!isKnown()) {
            long exact = points.stream().filter(ObservedOrder::isRoundOff).count();
            return exact > points.size() / 2 ? Verdict.EXACT : Verdict.NOT_KNOWN;
        }
        if (Math.abs(median) < CLOSE) {
            return Verdict.FLAT;
        }
        if (greatest - least > IRREGULAR) {
            return Verdict.IRREGULAR;
        }
        return median < 0 ? Verdict.RISING : against(expected(line));
    }

    private Verdict against(OptionalInt expected) {
        if (expected.isEmpty()) {
            return Verdict.SOME;
        }
        double more = median - expected.getAsInt();
        if (Math.abs(more) <= CLOSE) {
            return Verdict.AS_EXPECTED;
        }
        return more > 0 ? Verdict.HIGHER : Verdict.LOWER;
    }

    private static boolean isRoundOff(Point point) {
        return !point.errors().hasFailed() && point.errors().main() <= ROUND_OFF;
    }
}
