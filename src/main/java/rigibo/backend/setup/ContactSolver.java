package rigibo.backend.setup;

/**
 * How the impulses of resting contacts are found.
 *
 * <pre>{@code
 * pool.accuracy(Accuracy.GAME.withContactSolver(ContactSolver.BLOCK));
 * }</pre>
 */
public enum ContactSolver {
    /** One contact point after the other. */
    SEQUENTIAL,
    /** Both points of a flat contact at once, contact after contact. */
    BLOCK,
    /**
     * Islands of up to 192 rows solved whole, by trying sets of loaded ones, as far as that is
     * worth its time; what is larger as {@link #BLOCK}.
     */
    DIRECT
}
