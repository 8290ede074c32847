package rigibo.lab.hardcase;

/** What most cases of joints are held to. */
final class JointLimits {

    /** Most that what a joint holds may be off, m. */
    static final Limits ERROR = Limits.of(1e-4, 1e-9);

    /** Most that a place of closed form may be off, as a share of the scene's extent. */
    static final Limits PLACE = Limits.of(1e-3, 1e-6);

    /** Most that a force of statics may be off, as a share of it. */
    static final Limits FORCE = Limits.of(1e-2, 1e-4);

    private JointLimits() {}
}
