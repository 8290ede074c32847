package rigibo.backend.setup;

/**
 * At what time within a step impacts are resolved.
 *
 * <pre>{@code
 * pool.accuracy(Accuracy.GAME.withImpacts(ImpactMode.EVENTS));
 * }</pre>
 */
public enum ImpactMode {
    /** At the end of the step, when the bodies already overlap. */
    DISCRETE,
    /** Within the substep, at the time of impact of straight motion, which has a closed form. */
    SPLIT,
    /** For bodies in flight at their times of impact, in time order; inside piles as SPLIT. */
    EVENTS
}
