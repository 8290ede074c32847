package rigibo.backend.setup;

/**
 * A spring with a damper. Its stiffness follows when it is joined: k = m·(2πf)² with the reduced
 * mass m = mₐ·m_b/(mₐ + m_b) of the two bodies, or their reduced inertia where it turns them; c =
 * 2·ζ·m·2πf. It stays what it is when masses change later.
 *
 * <pre>{@code
 * JointSpring soft = new JointSpring(2, 0.5);
 * pool.join(WeldJoint.at(door, crate, 0, 2).with(JointSettings.NONE.spring(soft)));
 * }</pre>
 *
 * @param hertz 0 to 100,000 Hz; 0 is no spring
 * @param dampingRatio ζ, 0 to 100; 1 is critical
 */
public record JointSpring(double hertz, double dampingRatio) {

    /** No spring. */
    public static final JointSpring NONE = new JointSpring(0, 0);

    private static final double MOST_HERTZ = 1e5;
    private static final double MOST_DAMPING = 100;

    /**
     * Checks both numbers.
     *
     * @throws IllegalArgumentException when one is out of its range
     */
    public JointSpring {
        Require.within("JointSpring.hertz", hertz, 0, MOST_HERTZ, "Hz");
        Require.within("JointSpring.dampingRatio", dampingRatio, 0, MOST_DAMPING, "no unit");
    }

    /** Whether there is one. */
    public boolean isThere() {
        return hertz > 0;
    }
}
