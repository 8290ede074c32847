package rigibo.backend.setup;

/**
 * Where a joint holds a body, in the body's own frame, whose origin is its centre of mass.
 *
 * <pre>{@code
 * JointFrame corner = new JointFrame(0.5, 0.5, 0);
 * pool.join(new RevoluteJoint(door, crate, corner, JointFrame.CENTRE, JointSettings.NONE));
 * }</pre>
 *
 * @param x m, along the body's first axis
 * @param y m, along its second axis
 * @param angle of the joint's axis against the body's first one, rad, counter-clockwise
 */
public record JointFrame(double x, double y, double angle) {

    /** The centre of mass and the body's own axes. */
    public static final JointFrame CENTRE = new JointFrame(0, 0, 0);

    /** Farthest from the centre of mass that a joint may hold a body, m. */
    private static final double FARTHEST = 1e6;

    /**
     * Checks all numbers.
     *
     * @throws IllegalArgumentException when one is out of its range
     */
    public JointFrame {
        Require.within("JointFrame.x", x, -FARTHEST, FARTHEST, "m");
        Require.within("JointFrame.y", y, -FARTHEST, FARTHEST, "m");
        double most = BodyDefinition.MOST_ANGLE;
        Require.within("JointFrame.angle", angle, -most, most, "rad");
    }
}
