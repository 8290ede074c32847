package rigibo.backend.effect;

/**
 * Linear drag: an acceleration of k·v against the velocity, with k from the material. A free body's
 * speed decays exactly as e^(−kt).
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new Drag()));
 * crate.material(crate.material().drag(0.5)); // a force of 0.5 N·s/m for each kg
 * }</pre>
 */
public record Drag() implements Effect {
    @Override
    public Kind kind() {
        return Kind.DRAG;
    }
}
