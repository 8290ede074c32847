package rigibo.backend.setup;

import java.util.List;

/**
 * What may be set on joints of several kinds, and changed while they hold.
 *
 * <pre>{@code
 * JointSettings sprung = JointSettings.NONE.spring(new JointSpring(3, 0.7));
 * pool.join(RevoluteJoint.at(door, crate, 0, 2).with(sprung));
 * }</pre>
 *
 * @param limits of the joint's coordinate
 * @param motor that drives it
 * @param spring that pulls it to where it belongs
 * @param collideConnected whether the two bodies meet each other all the same
 * @param breakForce N, mean over a step, from which on the joint breaks; may be ∞
 * @param breakTorque N·m about the anchor on B, likewise
 */
public record JointSettings(
        JointLimits limits,
        JointMotor motor,
        JointSpring spring,
        boolean collideConnected,
        double breakForce,
        double breakTorque) {

    /** No limit, no motor, no spring, bodies that do not meet, and unbreakable. */
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
     * @throws IllegalArgumentException when one is missing or out of its range
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

    /** The same with other limits. */
    public JointSettings limits(JointLimits other) {
        return new JointSettings(other, motor, spring, collideConnected, breakForce, breakTorque);
    }

    /** The same with another motor. */
    public JointSettings motor(JointMotor other) {
        return new JointSettings(limits, other, spring, collideConnected, breakForce, breakTorque);
    }

    /** The same with another spring. */
    public JointSettings spring(JointSpring other) {
        return new JointSettings(limits, motor, other, collideConnected, breakForce, breakTorque);
    }

    /** The same with bodies that meet each other, or do not. */
    public JointSettings collideConnected(boolean meet) {
        return new JointSettings(limits, motor, spring, meet, breakForce, breakTorque);
    }

    /** The same that breaks from other forces (N) and torques (N·m) on; ∞ is never. */
    public JointSettings breaking(double force, double torque) {
        return new JointSettings(limits, motor, spring, collideConnected, force, torque);
    }

    /** What a kind of joint may have. */
    public enum Part {
        LIMITS,
        MOTOR,
        SPRING
    }

    /**
     * Refuses what a kind of joint has no use for.
     *
     * @throws IllegalArgumentException naming the joint and what it cannot have
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
