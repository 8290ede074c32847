package rigibo.backend.effect;

/**
 * Forces and torques applied by the caller; without it {@code applyForce} and {@code applyTorque}
 * throw.
 */
public record Thrust() implements Effect {}
