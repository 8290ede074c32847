package rigibo.backend.setup;

/**
 * How the time of impact is found once it is bracketed.
 *
 * <pre>{@code
 * pool.accuracy(Accuracy.GAME.withSearch(ImpactSearch.BISECTION));
 * }</pre>
 */
public enum ImpactSearch {
    /** Bisection: one evaluation halves the bracket. */
    BISECTION,
    /**
     * Bisection with interpolation (ITP): the same worst case, about 8 evaluations in practice.
     * Oliveira and Takahashi, "An enhancement of the bisection method average performance
     * preserving minmax optimality", 2020.
     */
    ITP
}
