package rigibo.backend.collision;

import rigibo.backend.setup.ImpactSearch;

/**
 * How far two shapes may move without touching, seen along one axis. What bounds it is the chord of
 * the gap over an interval and how much the gap can bend away from it.
 */
final class SafeAdvance {

    /** What a bound gives that never falls to the stopping gap. */
    private static final double CLEAR = Double.POSITIVE_INFINITY;

    private final RootSearch roots = new RootSearch();
    private ImpactSearch search;

    /** The stopping gap: between these two an impact is taken, m. */
    double least;

    double largest;

    /** How often a gap was measured since {@link #begin}. */
    int evaluations;

    /** Begins a search with a way to find roots. */
    void begin(ImpactSearch how) {
        search = how;
        evaluations = 0;
    }

    /** Sets the stopping gap, m. */
    void stopBetween(double lower, double upper) {
        least = lower;
        largest = upper;
    }

    /**
     * The end of an interval where it is clear, else a later time than the present up to which it
     * is: the first root of the gap where the bound leaves no earlier one, or of the bound itself.
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
            // Where the bend eats the gap, this interval is about the one that comes farthest.
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

    /** Whether the straight line's root suggests that the root of the gap is also its first. */
    private boolean isRootFirst(double gap, double endGap, double interval, double bend) {
        double closing = gap - least;
        double straight = interval * closing / (gap - endGap);
        return endGap < least && bend * straight * straight <= 2 * closing;
    }

    /**
     * How long in s the gap stays above the stopping gap for sure: the first root of gap + mτ −
     * κτ(Δ − τ)/2 = least, by the form that does not cancel; infinite where there is none ahead.
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
