package rigibo.backend.effect;

import java.util.List;

/**
 * Impacts rebound with the materials' elasticity e. Without this effect every impact has e = 0.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new Restitution()));
 * crate.material(crate.material().elasticity(0.8));
 * }</pre>
 */
public record Restitution() implements Effect {
    @Override
    public Kind kind() {
        return Kind.RESTITUTION;
    }

    @Override
    public List<List<Kind>> needs() {
        return List.of(List.of(Kind.CONTACTS));
    }
}
