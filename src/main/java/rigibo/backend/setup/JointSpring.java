package rigibo.backend.setup;

/**
 * A spring with a damper. When the bodies are joined, its stiffness k = m·(2πf)² and its damping c
 * = 2·ζ·m·2πf are computed from the reduced mass m = mₐ·m_b/(mₐ + m_b) of the two bodies, or from
 * their reduced moment of inertia for a spring of an angle. Later changes of mass do not change
 * them.
 *
 * <pre>{@code
 * JointSpring soft = new JointSpring(2, 0.5);
 * pool.join(WeldJoint.at(door, crate, 0, 2).with(JointSettings.NONE.spring(soft)));
 * }</pre>
 *
 * @param hertz frequency f of the undamped oscillation, 0 to 100,000 Hz; with 0 there is no spring
 * @param dampingRatio ζ, 0 to 100; 1 is critical damping
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

    /** Whether there is a spring: the frequency is not 0. */
    public boolean isThere() {
        return hertz > 0;
    }
}
