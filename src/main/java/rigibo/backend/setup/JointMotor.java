package rigibo.backend.setup;

/**
 * What drives a joint's coordinate. At speed 0 it is a brake, or dry friction.
 *
 * <pre>{@code
 * JointMotor brake = new JointMotor(0, 20); // N·m
 * pool.join(RevoluteJoint.at(door, crate, 0, 2).with(JointSettings.NONE.motor(brake)));
 * }</pre>
 *
 * @param speed that it drives to: rad/s of what turns, m/s of what slides
 * @param most that it drives with, N·m of what turns, N of what slides; may be ∞
 */
public record JointMotor(double speed, double most) {

    /** Nothing drives. */
    public static final JointMotor NONE = new JointMotor(0, 0);

    /** Fastest that anything is driven, rad/s or m/s. */
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

    /** Whether it drives at all. */
    public boolean drives() {
        return most > 0;
    }
}
