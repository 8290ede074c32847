package rigibo.backend.effect;

/**
 * A force per mass of k·v against motion, k from the material; the decay is exactly e^(−kt).
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new Drag()));
 * crate.material(crate.material().drag(0.5)); // a force of 0.5 N·s/m for each kg
 * }</pre>
 */
public record Drag() implements Effect {}
