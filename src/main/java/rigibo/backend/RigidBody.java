package rigibo.backend;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Material;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Pairs;

import java.util.List;

/**
 * A handle on one body of a {@link Pool}. Readers tell its state now; verbs change it between steps
 * and wake it. Once the body is removed, everything but {@link #isAlive}, {@link #name} and {@link
 * #toString} throws {@link IllegalStateException}.
 *
 * <pre>{@code
 * crate.velocity(2, 0);
 * crate.applyImpulse(0, 5, crate.x(), crate.y()); // N·s
 * System.out.println(crate.x() + " " + crate.y() + " " + crate.angle());
 * }</pre>
 */
public final class RigidBody {

    private static final int REMOVED = -1;

    private final Pool pool;
    private final String name;
    private int slot;
    private Object tag;

    /** Place in the pool's list of bodies, which tells who was added before whom. */
    int place;

    RigidBody(Pool pool, int slot, String name) {
        this.pool = pool;
        this.slot = slot;
        this.name = name;
    }

    /** World x of the centre of mass, m. */
    public double x() {
        return columns().x[slot];
    }

    /** World y of the centre of mass, m, up. */
    public double y() {
        return columns().y[slot];
    }

    /** Angle in rad, counter-clockwise, not wrapped: it counts full turns. */
    public double angle() {
        return columns().angle[slot];
    }

    /** Velocity of the centre of mass to the right, m/s. */
    public double velocityX() {
        return columns().velocityX[slot];
    }

    /** Velocity of the centre of mass upwards, m/s. */
    public double velocityY() {
        return columns().velocityY[slot];
    }

    /** Angular velocity in rad/s, counter-clockwise; 0 where rotation is not declared. */
    public double angularVelocity() {
        return columns().spinOf(slot);
    }

    /** Mass in kg; infinite for static and kinematic bodies. */
    public double mass() {
        return columns().type[slot] == BodyType.DYNAMIC
                ? columns().mass[slot]
                : Double.POSITIVE_INFINITY;
    }

    /**
     * Inertia about the centre of mass in kg·m², stated or of the shape, whether rotation is
     * declared or not; infinite for static and kinematic bodies.
     */
    public double inertia() {
        Bodies bodies = columns();
        if (bodies.type[slot] != BodyType.DYNAMIC) {
            return Double.POSITIVE_INFINITY;
        }
        return bodies.turns() ? bodies.inertia[slot] : Weight.of(bodies, slot).inertia();
    }

    /** Angular momentum about the centre of mass in kg·m²/s; 0 for static and kinematic bodies. */
    public double angularMomentum() {
        return columns().angularMomentum(slot);
    }

    /** Energy of motion and rotation in J; 0 for static and kinematic bodies. */
    public double kineticEnergy() {
        return columns().kineticEnergy(slot);
    }

    /** What may move the body. */
    public BodyType type() {
        return columns().type[slot];
    }

    /** The shape, whose centre of mass is at (x, y). */
    public Shape shape() {
        return columns().shape[slot];
    }

    /** What the body is made of. */
    public Material material() {
        return columns().material[slot];
    }

    /**
     * What the surface of one part of the shape is made of.
     *
     * @param part from 0
     * @throws IllegalArgumentException when there is no such part
     */
    public Material material(int part) {
        columns();
        return pool.editor().material(slot, part);
    }

    /** Whom the body meets; of a compound its first part. */
    public Filter filter() {
        return filter(0);
    }

    /**
     * Whom one part of the shape meets.
     *
     * @param part from 0
     * @throws IllegalArgumentException when there is no such part
     */
    public Filter filter(int part) {
        columns();
        return pool.editor().filter(slot, part);
    }

    /** Whether all parts of the shape touch nothing and tell who is inside. */
    public boolean isSensor() {
        Bodies bodies = columns();
        boolean isSensor = true;
        for (int s = slot; s != Pairs.NONE && isSensor; s = bodies.nextShapeOf(s)) {
            isSensor = bodies.isSensor(s);
        }
        return isSensor;
    }

    /** The joints that hold the body, in the order they were joined; a list of its own. */
    public List<Joint> joints() {
        columns();
        return pool.jointsOf(slot);
    }

    /** Whether the body is kept from turning. */
    public boolean rotationLocked() {
        return columns().isRotationLocked(slot);
    }

    /** Whether the body is kept from moving to the left and right. */
    public boolean xLocked() {
        return columns().isLockedInX(slot);
    }

    /** Whether the body is kept from moving up and down. */
    public boolean yLocked() {
        return columns().isLockedInY(slot);
    }

    /** The name from the definition; also after removal. */
    public String name() {
        return name;
    }

    /** Whether the body is simulated; a static body is never awake. */
    public boolean isAwake() {
        return columns().awake[slot] && columns().type[slot] != BodyType.STATIC;
    }

    /**
     * Writes the box that the broadphase keeps for the body, m: its bounds with a margin and, where
     * it is fast, its way ahead; its bounds alone where no contacts are declared.
     */
    public void sizeFixture(Aabb into) {
        columns();
        pool.sizeFixture(slot, into);
    }

    /** World x in m of a point of the body's own frame, whose origin is the centre of mass, m. */
    public double worldX(double localX, double localY) {
        Bodies bodies = columns();
        return bodies.x[slot] + (bodies.cos[slot] * localX - bodies.sin[slot] * localY);
    }

    /** World y in m of a point of the body's own frame, m. */
    public double worldY(double localX, double localY) {
        Bodies bodies = columns();
        return bodies.y[slot] + (bodies.sin[slot] * localX + bodies.cos[slot] * localY);
    }

    /**
     * World x in m of the point that was the origin where the corners of the polygon or the parts
     * of the compound were stated; the body's own x for shapes that are stated about their centre.
     *
     * <pre>{@code
     * Polygon wedge = Polygon.of(0, 0, 3, 0, 0, 1); // the right angle is its origin
     * double cornerX = pool.add(BodyDefinition.dynamic(wedge)).originX();
     * }</pre>
     */
    public double originX() {
        Shape shape = shape();
        return worldX(shape.originX(), shape.originY());
    }

    /** World y in m of the same point. */
    public double originY() {
        Shape shape = shape();
        return worldY(shape.originX(), shape.originY());
    }

    /** Where a world point in m is in the body's own frame, m along its first axis. */
    public double localX(double worldX, double worldY) {
        Bodies bodies = columns();
        double dx = worldX - bodies.x[slot];
        double dy = worldY - bodies.y[slot];
        return bodies.cos[slot] * dx + bodies.sin[slot] * dy;
    }

    /** Where a world point in m is in the body's own frame, m along its second axis. */
    public double localY(double worldX, double worldY) {
        Bodies bodies = columns();
        double dx = worldX - bodies.x[slot];
        double dy = worldY - bodies.y[slot];
        return bodies.cos[slot] * dy - bodies.sin[slot] * dx;
    }

    /** Velocity to the right in m/s of the body's point that is at a world point in m. */
    public double velocityXAt(double worldX, double worldY) {
        return velocityX() - angularVelocity() * (worldY - y());
    }

    /** Velocity upwards in m/s of the body's point that is at a world point in m. */
    public double velocityYAt(double worldX, double worldY) {
        return velocityY() + angularVelocity() * (worldX - x());
    }

    /**
     * World x in m of the centre of mass at a share of the last step, for pictures between two
     * steps: 0 where it began, 1 where it ended.
     */
    public double xAt(double share) {
        Bodies bodies = columns();
        double now = bodies.x[slot];
        return bodies.isMoved(slot) ? now - (1 - share) * (now - bodies.startX[slot]) : now;
    }

    /** World y in m of the centre of mass at a share of the last step. */
    public double yAt(double share) {
        Bodies bodies = columns();
        double now = bodies.y[slot];
        return bodies.isMoved(slot) ? now - (1 - share) * (now - bodies.startY[slot]) : now;
    }

    /** Angle in rad at a share of the last step. */
    public double angleAt(double share) {
        Bodies bodies = columns();
        double now = bodies.angle[slot];
        boolean hasTurned = bodies.turns() && bodies.isMoved(slot);
        return hasTurned ? now - (1 - share) * (now - bodies.startAngle[slot]) : now;
    }

    /** What {@link #tag(Object)} was given last, or null; no snapshot keeps it. */
    public Object tag() {
        return tag;
    }

    /** Keeps anything of the caller's with the body: a sprite, a player, a score. */
    public void tag(Object anything) {
        tag = anything;
    }

    /** Whether the body takes part; see {@link #disable}. */
    public boolean isEnabled() {
        return !columns().isDisabled(slot);
    }

    /** Whether the body is in its pool. */
    public boolean isAlive() {
        return slot != REMOVED;
    }

    /**
     * Places the body anew; its velocity stays.
     *
     * @param x world x of the centre of mass, m
     * @param y world y of the centre of mass, m, up
     * @param angle rad, counter-clockwise, within a million turns
     * @throws IllegalArgumentException when one is not finite
     */
    public void moveTo(double x, double y, double angle) {
        pool.editor(this).moveTo(slot, x, y, angle);
    }

    /**
     * Sets the velocity of the centre of mass; a static body's cannot be set.
     *
     * @param vx m/s, to the right
     * @param vy m/s, up
     * @throws IllegalArgumentException when one is not finite or the body is static
     */
    public void velocity(double vx, double vy) {
        pool.editor(this).motion.velocity(slot, vx, vy);
    }

    /**
     * Sets the angular velocity; a static body's cannot be set. Where rotation is not declared the
     * body does not turn, and does not begin to when it is declared later; nor does one that is
     * kept from turning.
     *
     * @param radiansPerSecond counter-clockwise
     * @throws IllegalArgumentException when it is not finite or the body is static
     */
    public void spin(double radiansPerSecond) {
        pool.editor(this).motion.spin(slot, radiansPerSecond);
    }

    /**
     * Applies a force during the next step: the origin report's thrust T at the point P.
     *
     * @param fx N, to the right
     * @param fy N, up
     * @param px world x of the point, m
     * @param py world y of the point, m
     * @throws IllegalStateException when the effect {@code Thrust} is not declared
     * @throws IllegalArgumentException when a number is not finite
     */
    public void applyForce(double fx, double fy, double px, double py) {
        pool.editor(this).motion.applyForce(slot, fx, fy, px, py);
    }

    /**
     * Applies a torque during the next step.
     *
     * @param torque N·m, counter-clockwise
     * @throws IllegalStateException when the effect {@code Thrust} is not declared
     * @throws IllegalArgumentException when it is not finite
     */
    public void applyTorque(double torque) {
        pool.editor(this).motion.applyTorque(slot, torque);
    }

    /**
     * Changes the momentum at once.
     *
     * @param jx N·s, to the right
     * @param jy N·s, up
     * @param px world x of the point, m
     * @param py world y of the point, m
     * @throws IllegalArgumentException when a number is not finite
     */
    public void applyImpulse(double jx, double jy, double px, double py) {
        pool.editor(this).motion.applyImpulse(slot, jx, jy, px, py);
    }

    /** Changes how the body answers forces; one that becomes static loses its velocity. */
    public void type(BodyType type) {
        pool.editor(this).type(slot, Require.present("RigidBody.type", type));
    }

    /**
     * Changes the material of all parts; the mass follows the density unless the definition stated
     * it.
     */
    public void material(Material material) {
        pool.editor(this).material(slot, Require.present("RigidBody.material", material));
    }

    /**
     * Changes the surface of one part of the shape; density and drag stay the body's.
     *
     * @param part from 0
     * @throws IllegalArgumentException when there is no such part
     */
    public void material(int part, Material surface) {
        pool.editor(this).material(slot, part, Require.present("RigidBody.material", surface));
    }

    /** Changes whom the body meets, with all its parts. */
    public void filter(Filter filter) {
        pool.editor(this).filter(slot, Require.present("RigidBody.filter", filter));
    }

    /**
     * Changes whom one part of the shape meets.
     *
     * @param part from 0
     * @throws IllegalArgumentException when there is no such part
     */
    public void filter(int part, Filter filter) {
        pool.editor(this).filter(slot, part, Require.present("RigidBody.filter", filter));
    }

    /** Keeps the body from turning from now on, or lets it turn again, from rest. */
    public void rotationLocked(boolean isLocked) {
        pool.editor(this).locks.rotation(slot, isLocked);
    }

    /**
     * Keeps the centre of mass from moving to the left and right from now on, or lets it move
     * again, from rest. While it is locked every velocity it is given along x is passed over.
     */
    public void xLocked(boolean isLocked) {
        pool.editor(this).locks.axes(slot, isLocked, yLocked());
    }

    /** Keeps the centre of mass from moving up and down likewise. */
    public void yLocked(boolean isLocked) {
        pool.editor(this).locks.axes(slot, xLocked(), isLocked);
    }

    /** Changes the shape about the same centre of mass; the mass follows likewise. */
    public void shape(Shape shape) {
        pool.editor(this).shape(slot, Require.present("RigidBody.shape", shape));
    }

    /**
     * Drives a kinematic body to a pose, in so many seconds of simulated time, where it then stops.
     * On the way it turns evenly, and its centre of mass goes along the arc that belongs to the
     * turn, so that a door turns about its hinge; straight where it does not turn, or by more than
     * half a turn. What stands on it is taken along. Any other velocity, pose or type ends it.
     *
     * <pre>{@code
     * RigidBody lift = pool.add(BodyDefinition.kinematic(Polygon.box(2, 0.2)));
     * lift.driveTo(0, 3, 0, 1.5); // 3 m up, in 1.5 s
     * }</pre>
     *
     * @param x world x of the centre of mass, m
     * @param y world y of the centre of mass, m, up
     * @param angle rad, counter-clockwise, within a million turns; passed over where rotation is
     *     not declared
     * @param seconds from now on, positive
     * @throws IllegalArgumentException when a number is out of its range, the body is not
     *     kinematic, or it would be faster than light
     */
    public void driveTo(double x, double y, double angle, double seconds) {
        pool.editor(this).motion.driveTo(slot, x, y, angle, seconds);
    }

    /**
     * Puts a dynamic body to sleep where it is, without velocity: it hangs there until something
     * touches it or it is woken. Others are not concerned.
     */
    public void sleep() {
        pool.editor(this).motion.sleep(slot);
    }

    /**
     * Takes the body out of the simulation until {@link #enable}: nothing moves it, nobody meets or
     * finds it, and it keeps what it has, its velocity too. Wakes what it touched.
     */
    public void disable() {
        pool.editor(this).disable(slot);
    }

    /** Lets a disabled body take part again, awake. */
    public void enable() {
        pool.editor(this).enable(slot);
    }

    /** Wakes the body and the island it rests in. */
    public void wake() {
        pool.editor(this).motion.wake(slot);
    }

    @Override
    public String toString() {
        String called = name.isEmpty() ? "RigidBody" : "RigidBody '" + name + "'";
        return isAlive()
                ? called + " at (" + x() + ", " + y() + ") m, " + angle() + " rad"
                : called + " (removed)";
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

    private Bodies columns() {
        requireAlive();
        return pool.columns();
    }
}
