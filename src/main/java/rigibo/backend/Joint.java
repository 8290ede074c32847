package rigibo.backend;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.JointReading;
import rigibo.backend.storage.JointStore;

/**
 * A handle on one joint of a {@link Pool}. Readers return its current state; verbs change the state
 * between steps and wake both bodies. After the joint was removed or broke, every method but {@link
 * #isAlive}, {@link #tag} and {@link #toString} throws {@link IllegalStateException}; so does every
 * verb but {@link #tag(Object)} within a step or from a visitor of the pool.
 *
 * <pre>{@code
 * Joint joint = pool.join(RevoluteJoint.at(door, crate, 0, 2));
 * pool.step(1 / 60.0);
 * System.out.println(joint.reactionForce() + " N, off by " + joint.error() + " m");
 * }</pre>
 */
public final class Joint {

    private static final int REMOVED = -1;

    private final Pool pool;
    private int slot;
    private Object tag;

    Joint(Pool pool, int slot) {
        this.pool = pool;
        this.slot = slot;
    }

    /** Whether the joint is in its pool. */
    public boolean isAlive() {
        return slot != REMOVED;
    }

    /** A definition that would make the joint again with its current settings. */
    public JointDefinition definition() {
        store();
        return pool.joinery().definition(slot);
    }

    /** The kind of the joint. */
    public JointKind kind() {
        return store().kindOf(slot);
    }

    /** The first body. */
    public RigidBody a() {
        return pool.handle(store().bodyA[slot]);
    }

    /** The second body. */
    public RigidBody b() {
        return pool.handle(store().bodyB[slot]);
    }

    /** World x of the anchor on A, m. */
    public double xA() {
        JointStore joints = store();
        return a().worldX(joints.anchorAX[slot], joints.anchorAY[slot]);
    }

    /** World y of the anchor on A, m, up. */
    public double yA() {
        JointStore joints = store();
        return a().worldY(joints.anchorAX[slot], joints.anchorAY[slot]);
    }

    /** World x of the anchor on B, m. */
    public double xB() {
        JointStore joints = store();
        return b().worldX(joints.anchorBX[slot], joints.anchorBY[slot]);
    }

    /** World y of the anchor on B, m, up. */
    public double yB() {
        JointStore joints = store();
        return b().worldY(joints.anchorBX[slot], joints.anchorBY[slot]);
    }

    /** Angle from A's axis to B's, rad, counter-clockwise, not wrapped. */
    public double angle() {
        JointStore joints = store();
        return b().angle() + joints.axisB[slot] - (a().angle() + joints.axisA[slot]);
    }

    /**
     * Displacement of B's anchor from A's along A's axis, m, with a sign; for a distance joint, the
     * distance between the anchors.
     */
    public double translation() {
        store();
        return reading().translation(slot);
    }

    /** Rate of change of the coordinate: rad/s for a hinge, m/s for all other kinds. */
    public double speed() {
        store();
        return reading().speed(slot);
    }

    /**
     * Position error: how far the anchors are from where the joint holds them, m (for a gear, error
     * of q₁ + ratio·q₂ in the unit of its coordinates); 0 for a joint that holds no point.
     */
    public double error() {
        store();
        return reading().error(slot);
    }

    /** Angle error, rad, 0 or more; 0 for a joint that holds no angle. */
    public double angleError() {
        store();
        return reading().angleError(slot);
    }

    /** Mean force of the joint on B to the right over the last step, N. */
    public double reactionForceX() {
        return store().reactionX[slot];
    }

    /** Mean force of the joint on B upwards over the last step, N. */
    public double reactionForceY() {
        return store().reactionY[slot];
    }

    /** Magnitude of the mean force on B over the last step, N. */
    public double reactionForce() {
        double x = reactionForceX();
        double y = reactionForceY();
        return Math.sqrt(x * x + y * y);
    }

    /**
     * Mean torque on B about its anchor over the last step, the motor's included, N·m,
     * counter-clockwise.
     */
    public double reactionTorque() {
        return store().reactionTurn[slot];
    }

    /** Stiffness of its spring, N/m, or N·m/rad for a spring of an angle; 0 without a spring. */
    public double stiffness() {
        return store().stiffness[slot];
    }

    /** Damping of its spring, N·s/m, or N·m·s/rad for a spring of an angle; 0 without a spring. */
    public double damping() {
        return store().damping[slot];
    }

    /** Energy stored in its spring, k·x²/2, J. */
    public double energy() {
        double away = store().stiffness[slot] == 0 ? 0 : reading().strain(slot);
        return stiffness() * away * away / 2;
    }

    /** The object last attached with {@link #tag(Object)}, or null. Snapshots do not keep it. */
    public Object tag() {
        return tag;
    }

    /** Attaches any object of the caller's to the joint. */
    public void tag(Object anything) {
        tag = anything;
    }

    /**
     * Sets limits, motor, spring and breaking loads from the next step on.
     *
     * @throws IllegalArgumentException when this kind of joint cannot have one of them
     */
    public void settings(JointSettings settings) {
        pool.joinery(this).settings(slot, Require.present("Joint.settings", settings));
    }

    /** Sets the limits: rad for a hinge, m for all other kinds. */
    public void limits(double lower, double upper) {
        JointSettings now = definition().settings();
        settings(now.limits(new JointLimits(lower, upper, now.limits().elasticity())));
    }

    /** Sets the motor: its speed in rad/s or m/s, and its greatest torque in N·m or force in N. */
    public void motor(double speed, double most) {
        settings(definition().settings().motor(new JointMotor(speed, most)));
    }

    /** Sets the spring: its frequency in Hz and its damping ratio, 1 for critical damping. */
    public void spring(double hertz, double dampingRatio) {
        settings(definition().settings().spring(new JointSpring(hertz, dampingRatio)));
    }

    /** Sets the force (N) and the torque (N·m) from which on the joint breaks; ∞ for never. */
    public void breaking(double force, double torque) {
        settings(definition().settings().breaking(force, torque));
    }

    /**
     * Sets the world point (m) that a mouse joint pulls to.
     *
     * @throws IllegalArgumentException when the joint is not a {@link MouseJoint}
     */
    public void target(double x, double y) {
        pool.joinery(this).target(slot, x, y);
    }

    /**
     * Sets the length of a {@link DistanceJoint}, m.
     *
     * @throws IllegalArgumentException when the joint is of another kind, or the length is negative
     */
    public void length(double metres) {
        pool.joinery(this).length(slot, metres);
    }

    @Override
    public String toString() {
        return isAlive()
                ? kind() + " joint of " + a() + " and " + b()
                : "joint (removed or broken)";
    }

    Pool pool() {
        return pool;
    }

    int slot() {
        return slot;
    }

    void markRemoved() {
        slot = REMOVED;
    }

    void requireAlive() {
        if (!isAlive()) {
            throw new IllegalStateException(this + " is no longer in its pool");
        }
    }

    private JointReading reading() {
        return pool.joinery().reading;
    }

    private JointStore store() {
        requireAlive();
        return pool.jointColumns();
    }
}
