package rigibo.backend.collision;

/**
 * The gap of two moving shapes along an axis that is no longer sought anew: never more than their
 * distance, and the least of smooth functions of time, one per pair of corners.
 */
interface GapAlong {

    /** The gap at a time in s, m. */
    double at(double time);

    /**
     * The most that the gap of any pair of corners curves upwards from the time the axis was found
     * at to another, m/s², zero or more. Over an interval Δ the gap stays above its chord but for
     * at most ⅛ of this times Δ².
     */
    double bend(double from, double to);
}
