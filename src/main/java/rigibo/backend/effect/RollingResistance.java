package rigibo.backend.effect;

/**
 * A torque up to c·N against rolling, from the materials' lever c; it stops and never reverses.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new RollingResistance()));
 * crate.material(crate.material().rollingResistance(0.01)); // a lever of 1 cm
 * }</pre>
 */
public record RollingResistance() implements Effect {}
