package rigibo.backend.setup;

/** How the impulses of resting contacts are found. */
public enum ContactSolver {
    /** One contact point after the other. */
    SEQUENTIAL,
    /** Both points of a flat contact at once, contact after contact. */
    BLOCK,
    /**
     * Islands that are not too large solved whole: up to 192 rows by trying sets of loaded ones, to
     * some thousand, if they hardly move, by splitting rows from their bounds; what is larger as
     * {@link #BLOCK}.
     */
    DIRECT
}
