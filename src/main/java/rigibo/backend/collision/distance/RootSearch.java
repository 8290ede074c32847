package rigibo.backend.collision.distance;

import rigibo.backend.setup.ImpactSearch;

/**
 * Finds the time at which the gap along an axis has closed to a wanted value, within a bracket: by
 * bisection or by ITP (I. F. D. Oliveira and R. H. C. Takahashi, An Enhancement of the Bisection
 * Method Average Performance Preserving Minmax Optimality, 2020). ITP interpolates, truncates
 * towards the middle, and projects so that the bracket never shrinks slower than by bisection.
 */
final class RootSearch {

    /** Most evaluations; a bracket halved so often is as short as doubles allow. */
    private static final int MOST_EVALUATIONS = 80;

    /** ITP's κ₁ times the length of the first bracket, with κ₂ = 2: the amount of truncation. */
    private static final double TRUNCATION = 0.2;

    /** Gap at the returned time, m. */
    double gap;

    /** Number of gap evaluations in all. */
    int evaluations;

    /**
     * Searches in [from, to], where the gap falls from {@code fromGap} to {@code toGap}, m.
     *
     * @return a time in s at which the gap lies in [least, most]; if round-off leaves none, the
     *     latest time found at which the gap is not less
     */
    double find(
            GapAlong axis,
            double from,
            double fromGap,
            double to,
            double toGap,
            double least,
            double most,
            ImpactSearch search) {
        double aim = (least + most) / 2;
        double slack = (most - least) / 2;
        double low = from;
        double high = to;
        double above = fromGap - aim;
        double below = toGap - aim;
        double allowed = high - low;
        for (int i = 0; i < MOST_EVALUATIONS && above > slack; i++) {
            double time =
                    switch (search) {
                        case BISECTION -> low + (high - low) / 2;
                        case ITP -> interpolate(low, above, high, below, to - from, allowed);
                    };
            if (!(time > low && time < high)) {
                break;
            }
            evaluations++;
            double value = axis.at(time) - aim;
            if (value >= -slack) {
                low = time;
                above = value;
            } else {
                high = time;
                below = value;
            }
            allowed /= 2;
        }
        gap = above + aim;
        return low;
    }

    private static double interpolate(
            double low, double above, double high, double below, double first, double allowed) {
        double width = high - low;
        double middle = low + width / 2;
        double straight = low + width * (above / (above - below));
        double truncation = TRUNCATION * width * width / first;
        double towards = middle - straight;
        double truncated =
                truncation <= Math.abs(towards)
                        ? straight + Math.copySign(truncation, towards)
                        : middle;
        double radius = Math.max(0, allowed - width / 2);
        if (Math.abs(truncated - middle) <= radius) {
            return truncated;
        }
        return truncated < middle ? middle - radius : middle + radius;
    }
}
