package rigibo.backend;

import rigibo.backend.setup.JointKind;
import rigibo.backend.setup.JointLimits;
import rigibo.backend.setup.JointMotor;
import rigibo.backend.setup.JointSettings;
import rigibo.backend.setup.JointSpring;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.JointStore;

/**
 * A handle on one joint of a {@link Pool}. Readers tell its state now; verbs change it between
 * steps and wake both bodies. Once the joint is removed or broken, everything but {@link #isAlive},
 * {@link #tag()} and {@link #toString} throws {@link IllegalStateException}.
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

    /** What the joint is now, as what it could be joined by again. */
    public JointDefinition definition() {
        store();
        return pool.joinery().definition(slot);
    }

    /** Of which kind it is. */
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

    /** World x in m of where it holds A. */
    public double xA() {
        JointStore joints = store();
        return a().worldX(joints.anchorAX[slot], joints.anchorAY[slot]);
    }

    /** World y in m of where it holds A, up. */
    public double yA() {
        JointStore joints = store();
        return a().worldY(joints.anchorAX[slot], joints.anchorAY[slot]);
    }

    /** World x in m of where it holds B. */
    public double xB() {
        JointStore joints = store();
        return b().worldX(joints.anchorBX[slot], joints.anchorBY[slot]);
    }

    /** World y in m of where it holds B, up. */
    public double yB() {
        JointStore joints = store();
        return b().worldY(joints.anchorBX[slot], joints.anchorBY[slot]);
    }

    /** Angle of B's axis against A's, rad, counter-clockwise, not wrapped. */
    public double angle() {
        JointStore joints = store();
        return b().angle() + joints.axisB[slot] - (a().angle() + joints.axisA[slot]);
    }

    /**
     * How far B's anchor is from A's, m: along A's axis, with a sign, or of a distance joint in a
     * straight line.
     */
    public double translation() {
        store();
        return reading().translation(slot);
    }

    /** How fast the coordinate grows: rad/s of a hinge, m/s of all others. */
    public double speed() {
        store();
        return reading().speed(slot);
    }

    /** How far in m what is held together has come apart; 0 of a joint that holds no point. */
    public double error() {
        store();
        return reading().error(slot);
    }

    /** By how much in rad an angle that is held is off; 0 of a joint that holds none. */
    public double angleError() {
        store();
        return reading().angleError(slot);
    }

    /** N to the right on B, mean of the last step. */
    public double reactionForceX() {
        return store().reactionX[slot];
    }

    /** N upwards on B, mean of the last step. */
    public double reactionForceY() {
        return store().reactionY[slot];
    }

    /** N on B, mean of the last step. */
    public double reactionForce() {
        double x = reactionForceX();
        double y = reactionForceY();
        return Math.sqrt(x * x + y * y);
    }

    /** N·m on B about its anchor, counter-clockwise, mean of the last step; the motor's too. */
    public double reactionTorque() {
        return store().reactionTurn[slot];
    }

    /** Stiffness of its spring, N/m, or N·m/rad where it turns; 0 without one. */
    public double stiffness() {
        return store().stiffness[slot];
    }

    /** Damping of its spring, N·s/m, or N·m·s/rad where it turns. */
    public double damping() {
        return store().damping[slot];
    }

    /** J in its spring: k·x²/2. */
    public double energy() {
        double away = store().stiffness[slot] == 0 ? 0 : reading().strain(slot);
        return stiffness() * away * away / 2;
    }

    /** What {@link #tag(Object)} was given last, or null; no snapshot keeps it. */
    public Object tag() {
        return tag;
    }

    /** Keeps anything of the caller's with the joint. */
    public void tag(Object anything) {
        tag = anything;
    }

    /**
     * Changes limits, motor, spring and breaking loads, from the next step on.
     *
     * @throws IllegalArgumentException when the joint has no use for one of them
     */
    public void settings(JointSettings settings) {
        pool.joinery(this).settings(slot, Require.present("Joint.settings", settings));
    }

    /** Changes the limits, rad of a hinge, m of all others. */
    public void limits(double lower, double upper) {
        JointSettings now = definition().settings();
        settings(now.limits(new JointLimits(lower, upper, now.limits().elasticity())));
    }

    /** Changes the motor: rad/s or m/s, and N·m or N at most. */
    public void motor(double speed, double most) {
        settings(definition().settings().motor(new JointMotor(speed, most)));
    }

    /** Changes the spring: Hz and damping ratio. */
    public void spring(double hertz, double dampingRatio) {
        settings(definition().settings().spring(new JointSpring(hertz, dampingRatio)));
    }

    /** Changes from which force (N) and torque (N·m) on the joint breaks. */
    public void breaking(double force, double torque) {
        settings(definition().settings().breaking(force, torque));
    }

    /**
     * Pulls to another world point in m.
     *
     * @throws IllegalArgumentException when the joint is no {@link MouseJoint}
     */
    public void target(double x, double y) {
        pool.joinery(this).target(slot, x, y);
    }

    /**
     * Changes the length of a {@link DistanceJoint}, m.
     *
     * @throws IllegalArgumentException when it is of another kind, or the length below 0
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
