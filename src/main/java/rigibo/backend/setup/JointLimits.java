package rigibo.backend.setup;

/**
 * Between which values a joint's coordinate stays, and how it rebounds from them.
 *
 * <pre>{@code
 * JointLimits stop = new JointLimits(-0.5, 0.5, 0); // half a radian either way
 * pool.join(RevoluteJoint.at(door, crate, 0, 2).with(JointSettings.NONE.limits(stop)));
 * }</pre>
 *
 * @param lower rad of a hinge, m of all others; may be −∞
 * @param upper not below {@code lower}; may be ∞
 * @param elasticity 0 to 1: the share of its speed with which the coordinate rebounds
 */
public record JointLimits(double lower, double upper, double elasticity) {

    /** No limit at all. */
    public static final JointLimits NONE =
            new JointLimits(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, 0);

    /**
     * Checks all numbers.
     *
     * @throws IllegalArgumentException when one is not a number, or the lower is over the upper
     */
    public JointLimits {
        if (!(lower <= upper) || lower == Double.POSITIVE_INFINITY) {
            throw new IllegalArgumentException(
                    "JointLimits.lower must not be over upper = " + upper + ", was " + lower);
        }
        if (upper == Double.NEGATIVE_INFINITY) {
            throw new IllegalArgumentException(
                    "JointLimits.upper must be over −∞ (rad or m), was " + upper);
        }
        Require.within("JointLimits.elasticity", elasticity, 0, 1, "no unit");
    }

    /** Whether there is a bound at all. */
    public boolean areAny() {
        return lower > Double.NEGATIVE_INFINITY || upper < Double.POSITIVE_INFINITY;
    }
}
