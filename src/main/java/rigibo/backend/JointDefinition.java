package rigibo.backend;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;

/**
 * What two bodies are joined by: handed to {@link Pool#join}, which makes a {@link Joint} of it.
 * Immutable: what changes a definition answers another one. A joint to the world is one to a static
 * body.
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

    /** The first body: the joint's axes turn with it. */
    RigidBody a();

    /** The second body: coordinates and speeds are its own, seen from the first. */
    RigidBody b();

    /** Limits, motor, spring, and from which loads on the joint breaks. */
    JointSettings settings();

    /**
     * A copy of this joint with other settings.
     *
     * @throws IllegalArgumentException when it has no use for one of them
     */
    JointDefinition with(JointSettings settings);

    /** Of which kind the joint is. */
    JointKind kind();

    /** A copy within limits that do not rebound: rad for a hinge, m for all other kinds. */
    default JointDefinition limits(double lower, double upper) {
        return limits(lower, upper, 0);
    }

    /** A copy within limits that rebound with a share of the speed, 0 to 1. */
    default JointDefinition limits(double lower, double upper, double elasticity) {
        return with(settings().limits(new JointLimits(lower, upper, elasticity)));
    }

    /** A copy driven to a speed (rad/s or m/s) by at most a torque (N·m) or a force (N). */
    default JointDefinition motor(double speed, double most) {
        return with(settings().motor(new JointMotor(speed, most)));
    }

    /** A copy with a spring of a frequency in Hz and a damping ratio, of which 1 is critical. */
    default JointDefinition spring(double hertz, double dampingRatio) {
        return with(settings().spring(new JointSpring(hertz, dampingRatio)));
    }

    /** A copy whose bodies collide with each other, or do not. */
    default JointDefinition collideConnected(boolean meet) {
        return with(settings().collideConnected(meet));
    }

    /** A copy that breaks from a force (N) or a torque (N·m) on; at ∞ it never does. */
    default JointDefinition breaking(double force, double torque) {
        return with(settings().breaking(force, torque));
    }
}
