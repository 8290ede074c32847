package rigibo.backend.setup;

/**
 * The anchor and axis of a joint on a body, in the body's frame, whose origin is its centre of
 * mass.
 *
 * <pre>{@code
 * JointFrame corner = new JointFrame(0.5, 0.5, 0);
 * pool.join(new RevoluteJoint(door, crate, corner, JointFrame.CENTRE, JointSettings.NONE));
 * }</pre>
 *
 * @param x anchor along the body's x axis, m
 * @param y anchor along the body's y axis, m
 * @param angle angle from the body's x axis to the joint's axis, rad, counter-clockwise
 */
public record JointFrame(double x, double y, double angle) {

    /** The anchor at the centre of mass and the axis along the body's x axis. */
    public static final JointFrame CENTRE = new JointFrame(0, 0, 0);

    /** Largest coordinate of an anchor accepted, m. */
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
