package rigibo.backend.setup;

/**
 * How the time of an impact is found once it is bracketed.
 *
 * <pre>{@code
 * pool.accuracy(Accuracy.GAME.withSearch(ImpactSearch.BISECTION));
 * }</pre>
 */
public enum ImpactSearch {
    /** Halving: one evaluation per factor 2 of precision. */
    BISECTION,
    /** Halving with interpolation (ITP): the same worst case, about 8 evaluations in practice. */
    ITP
}
