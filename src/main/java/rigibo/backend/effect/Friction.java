package rigibo.backend.effect;

import java.util.List;

/**
 * Coulomb friction in contacts and impacts, with μ from the materials. Without this effect all
 * surfaces are smooth.
 *
 * <pre>{@code
 * pool.effects(pool.effects().without(Friction.class)); // everything is ice
 * }</pre>
 */
public record Friction() implements Effect {
    @Override
    public Kind kind() {
        return Kind.FRICTION;
    }

    @Override
    public List<List<Kind>> needs() {
        return List.of(List.of(Kind.CONTACTS));
    }
}
