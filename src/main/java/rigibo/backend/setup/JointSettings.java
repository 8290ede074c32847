package rigibo.backend.setup;

import java.util.List;

/**
 * Settings that several kinds of joints share; they can be changed while the joint exists.
 *
 * <pre>{@code
 * JointSettings sprung = JointSettings.NONE.spring(new JointSpring(3, 0.7));
 * pool.join(RevoluteJoint.at(door, crate, 0, 2).with(sprung));
 * }</pre>
 *
 * @param limits limits of the joint's coordinate
 * @param motor motor that drives the coordinate
 * @param spring spring that pulls the coordinate to its rest value
 * @param collideConnected whether the two joined bodies collide with each other
 * @param breakForce mean force over a step above which the joint breaks, N, over 0; may be ∞
 * @param breakTorque mean torque about the anchor on B over a step above which the joint breaks,
 *     N·m, over 0; may be ∞
 */
public record JointSettings(
        JointLimits limits,
        JointMotor motor,
        JointSpring spring,
        boolean collideConnected,
        double breakForce,
        double breakTorque) {

    /** No limits, motor or spring; the two bodies do not collide; the joint never breaks. */
    public static final JointSettings NONE =
            new JointSettings(
                    JointLimits.NONE,
                    JointMotor.NONE,
                    JointSpring.NONE,
                    false,
                    Double.POSITIVE_INFINITY,
                    Double.POSITIVE_INFINITY);

    /**
     * Checks all parts.
     *
     * @throws IllegalArgumentException when one is null, or a breaking load is not over 0
     */
    public JointSettings {
        Require.present("JointSettings.limits", limits);
        Require.present("JointSettings.motor", motor);
        Require.present("JointSettings.spring", spring);
        requireOverZero("JointSettings.breakForce", breakForce, "N");
        requireOverZero("JointSettings.breakTorque", breakTorque, "N·m");
    }

    private static void requireOverZero(String field, double value, String unit) {
        if (!(value > 0)) {
            throw new IllegalArgumentException(
                    field + " must be over 0 (" + unit + "), was " + value);
        }
    }

    /** A copy with other limits. */
    public JointSettings limits(JointLimits other) {
        return new JointSettings(other, motor, spring, collideConnected, breakForce, breakTorque);
    }

    /** A copy with another motor. */
    public JointSettings motor(JointMotor other) {
        return new JointSettings(limits, other, spring, collideConnected, breakForce, breakTorque);
    }

    /** A copy with another spring. */
    public JointSettings spring(JointSpring other) {
        return new JointSettings(limits, motor, other, collideConnected, breakForce, breakTorque);
    }

    /** A copy that sets whether the two bodies collide with each other. */
    public JointSettings collideConnected(boolean meet) {
        return new JointSettings(limits, motor, spring, meet, breakForce, breakTorque);
    }

    /** A copy with other breaking loads, N and N·m; ∞ for never. */
    public JointSettings breaking(double force, double torque) {
        return new JointSettings(limits, motor, spring, collideConnected, force, torque);
    }

    /** The settings that only some kinds of joints can have. */
    public enum Part {
        LIMITS,
        MOTOR,
        SPRING
    }

    /**
     * Refuses settings that a kind of joint cannot have.
     *
     * @param joint name of the kind, for the message
     * @param parts the settings it can have
     * @throws IllegalArgumentException naming the joint and the setting it cannot have
     */
    public void requireOnly(String joint, Part... parts) {
        List<Part> may = List.of(parts);
        refuse(joint, "limits", limits.areAny() && !may.contains(Part.LIMITS));
        refuse(joint, "a motor", motor.drives() && !may.contains(Part.MOTOR));
        refuse(joint, "a spring", spring.isThere() && !may.contains(Part.SPRING));
    }

    private static void refuse(String joint, String what, boolean isWrong) {
        if (isWrong) {
            throw new IllegalArgumentException(joint + " cannot have " + what + ", was given");
        }
    }
}
