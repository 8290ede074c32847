package rigibo.backend.effect;

import java.util.List;

/**
 * Rolling resistance: a torque of up to c·N against rolling, with the lever c from the materials
 * and the normal force N. It can stop a rolling body but never reverse it.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new RollingResistance()));
 * crate.material(crate.material().rollingResistance(0.01)); // a lever of 1 cm
 * }</pre>
 */
public record RollingResistance() implements Effect {
    @Override
    public Kind kind() {
        return Kind.ROLLING_RESISTANCE;
    }

    @Override
    public List<List<Kind>> needs() {
        return List.of(List.of(Kind.CONTACTS), List.of(Kind.ROTATION));
    }
}
