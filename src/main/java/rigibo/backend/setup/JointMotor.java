package rigibo.backend.setup;

/**
 * A motor that drives a joint's coordinate to a speed. With speed 0 it acts as a brake, that is, as
 * dry friction.
 *
 * <pre>{@code
 * JointMotor brake = new JointMotor(0, 20); // N·m
 * pool.join(RevoluteJoint.at(door, crate, 0, 2).with(JointSettings.NONE.motor(brake)));
 * }</pre>
 *
 * @param speed wanted speed: rad/s for an angle, m/s for a displacement, within ±1e6
 * @param most greatest torque in N·m for an angle, force in N for a displacement; 0 or more, may be
 *     ∞; with 0 there is no motor
 */
public record JointMotor(double speed, double most) {

    /** No motor. */
    public static final JointMotor NONE = new JointMotor(0, 0);

    /** Highest speed accepted, rad/s or m/s. */
    private static final double FASTEST = 1e6;

    /**
     * Checks both numbers.
     *
     * @throws IllegalArgumentException when one is out of its range
     */
    public JointMotor {
        Require.within("JointMotor.speed", speed, -FASTEST, FASTEST, "rad/s or m/s");
        Require.within("JointMotor.most", most, 0, Double.POSITIVE_INFINITY, "N·m or N");
    }

    /** Whether there is a motor: {@code most} is not 0. */
    public boolean drives() {
        return most > 0;
    }
}
