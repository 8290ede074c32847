package rigibo.backend.effect;

import java.util.List;

/**
 * Impacts are resolved at their time within the step, so that fast bodies cannot pass through
 * others. Without this effect only overlap at the end of a step counts.
 *
 * <pre>{@code
 * // Without it, a shot of 100 m/s may pass a wall of 10 cm.
 * pool.effects(pool.effects().without(ContinuousImpacts.class));
 * }</pre>
 */
public record ContinuousImpacts() implements Effect {
    @Override
    public Kind kind() {
        return Kind.CONTINUOUS_IMPACTS;
    }

    @Override
    public List<List<Kind>> needs() {
        return List.of(List.of(Kind.CONTACTS));
    }
}
