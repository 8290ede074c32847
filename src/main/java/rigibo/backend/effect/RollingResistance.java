package rigibo.backend.effect;

/**
 * Rolling resistance: a torque of up to c·N against rolling, with the lever c from the materials
 * and the normal force N. It can stop a rolling body but never reverse it.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new RollingResistance()));
 * crate.material(crate.material().rollingResistance(0.01)); // a lever of 1 cm
 * }</pre>
 */
public record RollingResistance() implements Effect {}
