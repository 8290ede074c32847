package rigibo.backend;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;

/**
 * The definition of a joint between two bodies; {@link Pool#join} makes a {@link Joint} from it.
 * Immutable: methods that change something return a changed copy. To fix a body to the world, join
 * it to a static body.
 *
 * <pre>{@code
 * JointDefinition hinge = RevoluteJoint.at(door, crate, 0, 2).limits(-1, 1);
 * Joint first = pool.join(hinge);
 * Joint second = pool.join(hinge.breaking(5000, Double.POSITIVE_INFINITY));
 * }</pre>
 */
public sealed interface JointDefinition
        permits RevoluteJoint,
                PrismaticJoint,
                DistanceJoint,
                WeldJoint,
                WheelJoint,
                MotorJoint,
                MouseJoint,
                GearJoint,
                PulleyJoint,
                FilterJoint {

    /** The first body; the joint's axes turn with it. */
    RigidBody a();

    /** The second body; the joint's coordinate and speed are its motion relative to the first. */
    RigidBody b();

    /** Limits, motor, spring and breaking loads. */
    JointSettings settings();

    /**
     * A copy with other settings.
     *
     * @throws IllegalArgumentException when this kind of joint cannot have one of them
     */
    JointDefinition with(JointSettings settings);

    /** The kind of the joint. */
    JointKind kind();

    /** A copy with limits without rebound: rad for a hinge, m for all other kinds. */
    default JointDefinition limits(double lower, double upper) {
        return limits(lower, upper, 0);
    }

    /** A copy with limits that rebound with a share {@code elasticity} of the speed, 0 to 1. */
    default JointDefinition limits(double lower, double upper, double elasticity) {
        return with(settings().limits(new JointLimits(lower, upper, elasticity)));
    }

    /** A copy with a motor: its speed (rad/s or m/s) and greatest torque (N·m) or force (N). */
    default JointDefinition motor(double speed, double most) {
        return with(settings().motor(new JointMotor(speed, most)));
    }

    /** A copy with a spring: its frequency in Hz and its damping ratio, 1 for critical damping. */
    default JointDefinition spring(double hertz, double dampingRatio) {
        return with(settings().spring(new JointSpring(hertz, dampingRatio)));
    }

    /** A copy that sets whether its two bodies collide with each other. */
    default JointDefinition collideConnected(boolean meet) {
        return with(settings().collideConnected(meet));
    }

    /** A copy that breaks from a force (N) or a torque (N·m) on; ∞ for never. */
    default JointDefinition breaking(double force, double torque) {
        return with(settings().breaking(force, torque));
    }
}
