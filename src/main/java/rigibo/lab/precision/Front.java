package rigibo.lab.precision;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The Pareto front of points by error and cost: those to which no other is preferred, because none
 * is as accurate for less nor more accurate for as little (V. Pareto, "Manuale di economia
 * politica", 1906). The question is whether more cost bought anything, and so errors are compared
 * as they are, down to rounding. Points that failed or were not timed are on no front.
 */
final class Front {

    /** What is within 10 % of the front, of the cost. */
    static final double NEAR = 1.1;

    private static final Comparator<Point> BY_COST = Comparator.comparingDouble(Point::cost);

    private final List<Point> eligible;
    private final List<Point> points = new ArrayList<>();

    /** Of these. */
    Front(List<Point> all) {
        eligible = all.stream().filter(Front::isEligible).toList();
        List<Point> sorted = new ArrayList<>(eligible);
        sorted.sort(BY_COST.thenComparingDouble(Front::error));
        double least = Double.POSITIVE_INFINITY;
        for (Point point : sorted) {
            if (error(point) < least) {
                least = error(point);
                points.add(point);
            }
        }
    }

    /** Whether it is judged: it did not fail, and it was timed. */
    static boolean isEligible(Point point) {
        return !point.errors().hasFailed() && point.cost() > 0;
    }

    /** As far as it counts. */
    private static double error(Point point) {
        return Math.max(ObservedOrder.ROUND_OFF, point.errors().main());
    }

    /** Those on it, from the cheapest to the most accurate. */
    List<Point> points() {
        return points;
    }

    /** The cheapest that is no less accurate; empty where none is, not even the point itself. */
    Optional<Point> cheapestAsAccurateAs(Point point) {
        return eligible.stream().filter(other -> error(other) <= error(point)).min(BY_COST);
    }

    /**
     * How many times more it costs than the cheapest that is no less accurate, 1 on the front: the
     * distance to the front along the axis of cost. That axis and not the other, because it is cost
     * that is measured with a spread, while errors are the same in every run.
     */
    double excess(Point point) {
        return cheapestAsAccurateAs(point).map(other -> point.cost() / other.cost()).orElse(1.0);
    }

    /** Whether nothing that is no less accurate costs less than its cost / 1.1. */
    boolean isNear(Point point) {
        return excess(point) <= NEAR;
    }
}
