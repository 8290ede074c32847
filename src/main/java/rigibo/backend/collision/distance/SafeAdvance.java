package rigibo.backend.collision.distance;

import rigibo.backend.setup.ImpactSearch;

/**
 * The time by which two shapes can advance without touching, seen along one axis. The bound is the
 * chord of the gap over an interval, minus the most that the gap can bend away from it.
 */
final class SafeAdvance {

    /** Returned for a bound that never falls to the stopping gap. */
    private static final double CLEAR = Double.POSITIVE_INFINITY;

    private final RootSearch roots = new RootSearch();
    private ImpactSearch search;

    /** Range of the stopping gap, m: a gap between these two is taken as an impact. */
    double least;

    double largest;

    /** Number of gap evaluations since {@link #begin}. */
    int evaluations;

    /** Begins a search with a method to find roots. */
    void begin(ImpactSearch how) {
        search = how;
        evaluations = 0;
    }

    /** Sets the range of the stopping gap, m. */
    void stopBetween(double lower, double upper) {
        least = lower;
        largest = upper;
    }

    /**
     * Returns the end of an interval if the gap stays clear in it, otherwise a later time than the
     * present up to which it does: the first root of the gap if the bound has none before it, or
     * else the first root of the bound.
     */
    double from(GapAlong axis, double time, double gap, double firstInterval) {
        double interval = firstInterval;
        while (true) {
            evaluations++;
            double endGap = axis.at(time + interval);
            double bend = axis.bend(time, time + interval);
            double safe = clearFor(gap, endGap, interval, bend);
            if (safe < interval && isRootFirst(gap, endGap, interval, bend)) {
                interval = rootAfter(axis, time, gap, interval, endGap) - time;
                safe = clearFor(gap, roots.gap, interval, bend);
            }
            if (!(safe < interval)) {
                return time + interval;
            }
            if (safe >= interval / 4) {
                return time + safe;
            }
            // Where the curvature term uses up the gap, this is about the interval that advances
            // farthest.
            interval = Math.min(interval / 2, 2 * Math.sqrt(safe * interval));
        }
    }

    private double rootAfter(
            GapAlong axis, double time, double gap, double interval, double endGap) {
        int before = roots.evaluations;
        double root = roots.find(axis, time, gap, time + interval, endGap, least, largest, search);
        evaluations += roots.evaluations - before;
        return root;
    }

    /** Whether the root of the chord suggests that the root of the gap is also its first one. */
    private boolean isRootFirst(double gap, double endGap, double interval, double bend) {
        double closing = gap - least;
        double straight = interval * closing / (gap - endGap);
        return endGap < least && bend * straight * straight <= 2 * closing;
    }

    /**
     * Time in s for which the gap certainly stays above the stopping gap: the first root of gap +
     * mτ − κτ(Δ − τ)/2 = least, in the form without cancellation; infinite if there is none ahead.
     */
    private double clearFor(double gap, double endGap, double interval, double bend) {
        double half = bend / 2;
        double slope = (endGap - gap) / interval - half * interval;
        double closing = gap - least;
        double discriminant = slope * slope - 4 * half * closing;
        return slope < 0 && discriminant >= 0
                ? 2 * closing / (-slope + Math.sqrt(discriminant))
                : CLEAR;
    }
}
