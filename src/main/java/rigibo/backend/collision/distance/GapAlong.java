package rigibo.backend.collision.distance;

/**
 * The gap of two moving shapes along an axis that the search keeps for several rounds. It is never
 * more than their distance, and it is the least of smooth functions of time, one per pair of
 * corners.
 */
interface GapAlong {

    /** The gap at a time in s, m. */
    double at(double time);

    /**
     * Upper bound on the upward curvature, between two times, of the gap of any pair of corners,
     * m/s², zero or more. Over an interval Δ the gap lies below its chord by at most ⅛ of this
     * times Δ².
     */
    double bend(double from, double to);
}
