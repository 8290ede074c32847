package rigibo.backend.storage;

import rigibo.backend.setup.Accuracy;

/** How much of an overlap is not removed, in widths ({@link PairTolerances#width}). */
public final class KeptOverlap {

    /**
     * What is kept at least: a resting contact that parted by round-off would lose its load for a
     * substep and tremble.
     */
    public static final double LEAST = 1e-5;

    /**
     * What is kept in a crowd at most. Pushing one body of a crowd opens gaps around others, which
     * keep closing for as long as any overlap is removed.
     */
    private static final double MOST = 1e-3;

    /** Kept overlap in a crowd, as a multiple of the impact tolerance. */
    private static final double BY_TOLERANCE = 10;

    /**
     * Factor on it in a calm crowd. The last of an overlap is removed ever more slowly, and as long
     * as any is removed, the crowd does not rest.
     */
    private static final double IF_CALM = 2;

    private KeptOverlap() {}

    /** Kept overlap, in widths; in a crowd ten times the impact tolerance, within bounds. */
    public static double of(boolean isCrowd, Accuracy accuracy) {
        if (!isCrowd) {
            return LEAST;
        }
        return Math.max(LEAST, Math.min(MOST, BY_TOLERANCE * accuracy.impactTolerance()));
    }

    /** Kept overlap of a calm island, in widths. */
    public static double ifCalm(boolean isCrowd, Accuracy accuracy) {
        return isCrowd ? IF_CALM * of(true, accuracy) : LEAST;
    }
}
