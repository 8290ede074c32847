package rigibo.lab.precision;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;

/**
 * The Pareto front of points by error and cost (V. Pareto, "Manuale di economia politica", 1906):
 * the points for which no other is at least as accurate and cheaper, or as cheap and more accurate.
 * The question is whether a higher cost gained anything, so errors are compared exactly. Points
 * that failed or were not timed are not considered.
 */
final class Front {

    /** The factor of cost within which a point counts as near the front. */
    static final double NEAR = 1.1;

    private static final Comparator<Point> BY_COST = Comparator.comparingDouble(Point::cost);

    private final List<Point> eligible;
    private final List<Point> points = new ArrayList<>();

    /** The front of some points. */
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

    /** Whether a point is considered: it did not fail, and it was timed. */
    static boolean isEligible(Point point) {
        return !point.errors().hasFailed() && point.cost() > 0;
    }

    /** As far as it counts. */
    private static double error(Point point) {
        return Math.max(ObservedOrder.ROUND_OFF, point.errors().main());
    }

    /** The points on the front, from the cheapest to the most accurate. */
    List<Point> points() {
        return points;
    }

    /** The cheapest point that is at least as accurate; empty if there is none. */
    Optional<Point> cheapestAsAccurateAs(Point point) {
        return eligible.stream().filter(other -> error(other) <= error(point)).min(BY_COST);
    }

    /**
     * The cost of a point over that of the cheapest point that is at least as accurate; 1 on the
     * front. This is the distance to the front along the axis of cost, since costs scatter, while
     * errors are equal in every run.
     */
    double excess(Point point) {
        return cheapestAsAccurateAs(point).map(other -> point.cost() / other.cost()).orElse(1.0);
    }

    /** Whether no point that is at least as accurate costs less than 1/1.1 of its cost. */
    boolean isNear(Point point) {
        return excess(point) <= NEAR;
    }
}
