package rigibo.backend.setup;

/**
 * The limits of a joint's coordinate, and how it rebounds from them.
 *
 * <pre>{@code
 * JointLimits stop = new JointLimits(-0.5, 0.5, 0); // half a radian either way
 * pool.join(RevoluteJoint.at(door, crate, 0, 2).with(JointSettings.NONE.limits(stop)));
 * }</pre>
 *
 * @param lower least value: rad for a hinge, m for all other kinds; may be −∞
 * @param upper greatest value, in the same unit, not below {@code lower}; may be ∞
 * @param elasticity rebound speed as a share of the impact speed, 0 to 1
 */
public record JointLimits(double lower, double upper, double elasticity) {

    /** No limit at all. */
    public static final JointLimits NONE =
            new JointLimits(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, 0);

    /**
     * Checks all numbers.
     *
     * @throws IllegalArgumentException when one is NaN, {@code lower} exceeds {@code upper}, or
     *     {@code elasticity} is not 0 to 1
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

    /** Whether at least one limit is finite. */
    public boolean areAny() {
        return lower > Double.NEGATIVE_INFINITY || upper < Double.POSITIVE_INFINITY;
    }
}
