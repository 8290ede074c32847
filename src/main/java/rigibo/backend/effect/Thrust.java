package rigibo.backend.effect;

/**
 * Forces and torques applied by the caller. Without this effect {@code RigidBody.applyForce} and
 * {@code applyTorque} throw.
 *
 * <pre>{@code
 * pool.effects(pool.effects().with(new Thrust()));
 * crate.applyForce(0, 200, crate.x(), crate.y()); // N, for the next step
 * }</pre>
 */
public record Thrust() implements Effect {
    @Override
    public Kind kind() {
        return Kind.THRUST;
    }
}
