package rigibo.backend.setup;

/**
 * How the impulses of contacts in piles are solved for.
 *
 * <pre>{@code
 * pool.accuracy(Accuracy.GAME.withContactSolver(ContactSolver.BLOCK));
 * }</pre>
 */
public enum ContactSolver {
    /** Passes over the contacts, one contact point after the other (projected Gauss–Seidel). */
    SEQUENTIAL,
    /** Passes over the contacts that solve both points of a contact together. */
    BLOCK,
    /**
     * Islands of up to 192 rows are solved whole: sets of loaded rows are tried as systems of
     * linear equations, within a budget of time. Larger islands are solved as with {@link #BLOCK}.
     */
    DIRECT
}
