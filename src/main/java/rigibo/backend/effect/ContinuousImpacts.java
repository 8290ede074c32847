package rigibo.backend.effect;

/**
 * Impacts at their own time within the step; left out, only overlap at the step's end counts.
 *
 * <pre>{@code
 * // Then a shot of 100 m/s may pass a wall of 10 cm.
 * pool.effects(pool.effects().without(ContinuousImpacts.class));
 * }</pre>
 */
public record ContinuousImpacts() implements Effect {}
