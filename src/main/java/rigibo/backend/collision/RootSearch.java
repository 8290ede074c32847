package rigibo.backend.collision;

import rigibo.backend.setup.ImpactSearch;

/**
 * The time at which a gap along an axis has closed to the stopping gap, within a bracket, by
 * halving or by ITP (Oliveira and Takahashi, "An enhancement of the bisection method average
 * performance preserving minmax optimality", 2020): interpolate, truncate towards the middle, and
 * project so that the bracket never shrinks slower than by halving.
 */
final class RootSearch {

    /** A gap of up to this many times the stopping gap will do. */
    private static final double SLACK = 1.2;

    /** More halvings than doubles have bits change nothing. */
    private static final int MOST_EVALUATIONS = 64;

    /** ITP's weight of the truncation, per length of the first bracket, and its exponent 2. */
    private static final double TRUNCATION = 0.1;

    /** Returns the latest time found at which the gap is still at least the stopping gap, s. */
    double find(
            AxisGap gap,
            double from,
            double fromGap,
            double to,
            double toGap,
            double stop,
            ImpactSearch search) {
        double low = from;
        double high = to;
        double above = fromGap - stop;
        double below = toGap - stop;
        double first = to - from;
        double allowed = first;
        for (int i = 0; i < MOST_EVALUATIONS && above > (SLACK - 1) * stop; i++) {
            double middle = (low + high) / 2;
            double time =
                    switch (search) {
                        case BISECTION -> middle;
                        case ITP -> interpolate(low, above, high, below, first, allowed);
                    };
            if (!(time > low && time < high)) {
                return low;
            }
            double value = gap.at(time) - stop;
            if (value >= 0) {
                low = time;
                above = value;
            } else {
                high = time;
                below = value;
            }
            allowed /= 2;
        }
        return low;
    }

    private static double interpolate(
            double low, double above, double high, double below, double first, double allowed) {
        double middle = (low + high) / 2;
        double width = high - low;
        double falsi = (low * -below + high * above) / (above - below);
        double truncation = Math.min(TRUNCATION / first * width * width, Math.abs(middle - falsi));
        // Towards the low end rather than the middle: the answer must not overlap.
        double truncated = falsi - Math.min(truncation, falsi - low) / 2;
        double radius = Math.max(0, allowed - width / 2);
        if (Math.abs(truncated - middle) <= radius) {
            return truncated;
        }
        return truncated < middle ? middle - radius : middle + radius;
    }
}
