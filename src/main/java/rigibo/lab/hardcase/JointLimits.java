package rigibo.lab.hardcase;

/** The limits of most cases of joints. */
final class JointLimits {

    /** The largest error of a joint, m. */
    static final Limits ERROR = Limits.of(1e-4, 1e-9);

    /** The largest error of a place that is known, as a share of the scene's extent. */
    static final Limits PLACE = Limits.of(1e-3, 1e-6);

    /** The largest relative error of a force that statics gives. */
    static final Limits FORCE = Limits.of(1e-2, 1e-4);

    private JointLimits() {}
}
