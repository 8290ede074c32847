package rigibo.backend.setup;

/** How the impulses of resting contacts are found. */
public enum ContactSolver {
    /** One contact point after the other. */
    SEQUENTIAL,
    /** Both points of a flat contact at once, contact after contact. */
    BLOCK,
    /** Islands of up to 192 rows by elimination, larger ones as {@link #BLOCK}. */
    DIRECT
}
