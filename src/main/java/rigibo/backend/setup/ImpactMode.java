package rigibo.backend.setup;

/**
 * When within a step an impact happens.
 *
 * <pre>{@code
 * pool.accuracy(Accuracy.GAME.withImpacts(ImpactMode.EVENTS));
 * }</pre>
 */
public enum ImpactMode {
    /** At the end of the step, where bodies already overlap. */
    DISCRETE,
    /** Inside the substep, at the time a straight line gives in closed form. */
    SPLIT,
    /** Bodies in flight at their exact times, in time order; inside piles split. */
    EVENTS
}
