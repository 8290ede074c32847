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
 * A handle on one body of a {@link Pool}. Readers return its current state; verbs change the state
 * between steps and wake the body. After removal every method but {@link #isAlive}, {@link #name},
 * {@link #tag} and {@link #toString} throws {@link IllegalStateException}; so does every verb but
 * {@link #tag(Object)} within a step or from a visitor of the pool.
 *
 * <pre>{@code
 * crate.velocity(2, 0);
 * crate.applyImpulse(0, 5, crate.x(), crate.y()); // N·s
 * System.out.println(crate.x() + " " + crate.y() + " " + crate.angle());
 * }</pre>
 */
public final class RigidBody {

    private final Pool pool;
    private final String name;

    /** The slot; once the body is removed, the complement of the slot it had. */
    private int slot;

    private Object tag;

    /** Index in the pool's list of bodies; a body added earlier has a smaller one. */
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

    /** Angle in rad, counter-clockwise. It is not wrapped: full turns add up. */
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
     * Moment of inertia about the centre of mass in kg·m²: as the definition stated it, otherwise
     * that of the shape. It is known even if rotation is not declared; infinite for static and
     * kinematic bodies.
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

    /** Kinetic energy of motion and rotation in J; 0 for static and kinematic bodies. */
    public double kineticEnergy() {
        return columns().kineticEnergy(slot);
    }

    /** Whether the body is dynamic, static or kinematic. */
    public BodyType type() {
        return columns().type[slot];
    }

    /** The shape; its centre of mass lies at (x, y). */
    public Shape shape() {
        return columns().shape[slot];
    }

    /** The material of the body; of a compound, that of its first part. */
    public Material material() {
        return columns().material[slot];
    }

    /**
     * The surface material of one part of the shape.
     *
     * @param part index of the part, from 0
     * @throws IllegalArgumentException when there is no such part
     */
    public Material material(int part) {
        columns();
        return pool.editor().material(slot, part);
    }

    /** The collision filter of the body; of a compound, that of its first part. */
    public Filter filter() {
        return filter(0);
    }

    /**
     * The collision filter of one part of the shape.
     *
     * @param part index of the part, from 0
     * @throws IllegalArgumentException when there is no such part
     */
    public Filter filter(int part) {
        columns();
        return pool.editor().filter(slot, part);
    }

    /**
     * Whether all parts of the shape are sensors, which touch nothing and report the bodies inside
     * them.
     */
    public boolean isSensor() {
        Bodies bodies = columns();
        boolean isSensor = true;
        for (int s = slot; s != Pairs.NONE && isSensor; s = bodies.nextShapeOf(s)) {
            isSensor = bodies.isSensor(s);
        }
        return isSensor;
    }

    /** The joints that hold the body, in the order they were joined, as a new list. */
    public List<Joint> joints() {
        columns();
        return pool.jointsOf(slot);
    }

    /** Whether the rotation of the body is locked. */
    public boolean rotationLocked() {
        return columns().isRotationLocked(slot);
    }

    /** Whether the centre of mass is locked in x. */
    public boolean xLocked() {
        return columns().isLockedInX(slot);
    }

    /** Whether the centre of mass is locked in y. */
    public boolean yLocked() {
        return columns().isLockedInY(slot);
    }

    /** The name from the definition. It can be read after removal too. */
    public String name() {
        return name;
    }

    /** Whether the body is awake, that is, simulated in the next step. A static body never is. */
    public boolean isAwake() {
        return columns().awake[slot] && columns().type[slot] != BodyType.STATIC;
    }

    /**
     * Writes the fixture that the broadphase keeps for the body, in m: its bounds enlarged by a
     * margin and, for a fast body, by its path in the next step. Without {@code Contacts} it is the
     * bounds alone.
     *
     * @param into is overwritten
     */
    public void sizeFixture(Aabb into) {
        columns();
        pool.sizeFixture(slot, into);
    }

    /** World x in m of a point (m) in the body's frame, whose origin is the centre of mass. */
    public double worldX(double localX, double localY) {
        Bodies bodies = columns();
        return bodies.x[slot] + (bodies.cos[slot] * localX - bodies.sin[slot] * localY);
    }

    /** World y in m of a point (m) in the body's frame, whose origin is the centre of mass. */
    public double worldY(double localX, double localY) {
        Bodies bodies = columns();
        return bodies.y[slot] + (bodies.sin[slot] * localX + bodies.cos[slot] * localY);
    }

    /**
     * World x in m of the origin of the coordinates in which the polygon's corners or the
     * compound's parts were stated. For shapes stated about their centre it equals {@link #x}.
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

    /** World y in m of the origin of the coordinates in which the shape was stated. */
    public double originY() {
        Shape shape = shape();
        return worldY(shape.originX(), shape.originY());
    }

    /** The x coordinate of a world point (m) in the body's frame, m. */
    public double localX(double worldX, double worldY) {
        Bodies bodies = columns();
        double dx = worldX - bodies.x[slot];
        double dy = worldY - bodies.y[slot];
        return bodies.cos[slot] * dx + bodies.sin[slot] * dy;
    }

    /** The y coordinate of a world point (m) in the body's frame, m. */
    public double localY(double worldX, double worldY) {
        Bodies bodies = columns();
        double dx = worldX - bodies.x[slot];
        double dy = worldY - bodies.y[slot];
        return bodies.cos[slot] * dy - bodies.sin[slot] * dx;
    }

    /** Velocity to the right, m/s, of the material point of the body at a world point (m). */
    public double velocityXAt(double worldX, double worldY) {
        return velocityX() - angularVelocity() * (worldY - y());
    }

    /** Velocity upwards, m/s, of the material point of the body at a world point (m). */
    public double velocityYAt(double worldX, double worldY) {
        return velocityY() + angularVelocity() * (worldX - x());
    }

    /**
     * World x of the centre of mass in m, interpolated linearly over the last step: for drawing
     * frames between two steps.
     *
     * @param share 0 for the start of the last step, 1 for its end
     */
    public double xAt(double share) {
        Bodies bodies = columns();
        double now = bodies.x[slot];
        return bodies.isMoved(slot) ? now - (1 - share) * (now - bodies.startX[slot]) : now;
    }

    /** World y of the centre of mass in m, interpolated as {@link #xAt} is. */
    public double yAt(double share) {
        Bodies bodies = columns();
        double now = bodies.y[slot];
        return bodies.isMoved(slot) ? now - (1 - share) * (now - bodies.startY[slot]) : now;
    }

    /** Angle in rad, interpolated as {@link #xAt} is. */
    public double angleAt(double share) {
        Bodies bodies = columns();
        double now = bodies.angle[slot];
        boolean hasTurned = bodies.turns() && bodies.isMoved(slot);
        return hasTurned ? now - (1 - share) * (now - bodies.startAngle[slot]) : now;
    }

    /** The object last attached with {@link #tag(Object)}, or null. Snapshots do not keep it. */
    public Object tag() {
        return tag;
    }

    /** Attaches any object of the caller's to the body: a sprite, a player, a score. */
    public void tag(Object anything) {
        tag = anything;
    }

    /** Whether the body takes part in the simulation; see {@link #disable}. */
    public boolean isEnabled() {
        return !columns().isDisabled(slot);
    }

    /** Whether the body is in its pool. */
    public boolean isAlive() {
        return slot >= 0;
    }

    /**
     * Moves the body to a pose at once; its velocity does not change.
     *
     * @param x world x of the centre of mass, m
     * @param y world y of the centre of mass, m, up
     * @param angle rad, counter-clockwise, within a million turns
     * @throws IllegalArgumentException when a number is out of its range
     */
    public void moveTo(double x, double y, double angle) {
        pool.editor(this).moveTo(slot, x, y, angle);
    }

    /**
     * Sets the velocity of the centre of mass. Along a locked axis it stays 0.
     *
     * @param vx m/s, to the right
     * @param vy m/s, up
     * @throws IllegalArgumentException when a number is not within ± the speed of light, or not 0
     *     for a static body
     */
    public void velocity(double vx, double vy) {
        pool.editor(this).motion.velocity(slot, vx, vy);
    }

    /**
     * Sets the angular velocity. The call has no effect where {@code Rotation} is not declared or
     * the body's rotation is locked; the value is not remembered for later either.
     *
     * @param radiansPerSecond rad/s, counter-clockwise, within ±1e6
     * @throws IllegalArgumentException when it is out of its range, or not 0 for a static body
     */
    public void spin(double radiansPerSecond) {
        pool.editor(this).motion.spin(slot, radiansPerSecond);
    }

    /**
     * Applies a force during the whole next step; forces applied between two steps add up.
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
     * Applies a torque during the whole next step; torques applied between two steps add up.
     *
     * @param torque N·m, counter-clockwise
     * @throws IllegalStateException when the effect {@code Thrust} is not declared
     * @throws IllegalArgumentException when it is not finite
     */
    public void applyTorque(double torque) {
        pool.editor(this).motion.applyTorque(slot, torque);
    }

    /**
     * Applies an impulse at a point: velocity and angular velocity change at once.
     *
     * @param jx N·s, to the right
     * @param jy N·s, up
     * @param px world x of the point, m
     * @param py world y of the point, m
     * @throws IllegalArgumentException when a number is not finite, or the body would become faster
     *     than light or than 1e6 rad/s
     */
    public void applyImpulse(double jx, double jy, double px, double py) {
        pool.editor(this).motion.applyImpulse(slot, jx, jy, px, py);
    }

    /**
     * Makes the body dynamic, static or kinematic. A body that becomes static loses its velocity.
     *
     * @throws IllegalArgumentException when a body with a {@code Chain} should become dynamic
     */
    public void type(BodyType type) {
        pool.editor(this).type(slot, Require.present("RigidBody.type", type));
    }

    /**
     * Sets the material of all parts. The mass follows from the new density, unless the definition
     * stated a mass.
     */
    public void material(Material material) {
        pool.editor(this).material(slot, Require.present("RigidBody.material", material));
    }

    /**
     * Sets the surface material of one part of the shape. Its density and drag are ignored: those
     * are the body's.
     *
     * @param part index of the part, from 0
     * @throws IllegalArgumentException when there is no such part
     */
    public void material(int part, Material surface) {
        pool.editor(this).material(slot, part, Require.present("RigidBody.material", surface));
    }

    /** Sets the collision filter of all parts. */
    public void filter(Filter filter) {
        pool.editor(this).filter(slot, Require.present("RigidBody.filter", filter));
    }

    /**
     * Sets the collision filter of one part of the shape.
     *
     * @param part index of the part, from 0
     * @throws IllegalArgumentException when there is no such part
     */
    public void filter(int part, Filter filter) {
        pool.editor(this).filter(slot, part, Require.present("RigidBody.filter", filter));
    }

    /** Locks the rotation of the body, which stops its spin, or unlocks it. */
    public void rotationLocked(boolean isLocked) {
        pool.editor(this).locks.rotation(slot, isLocked);
    }

    /**
     * Locks the centre of mass in x, which stops its motion along x, or unlocks it. While it is
     * locked, every velocity set along x is ignored.
     */
    public void xLocked(boolean isLocked) {
        pool.editor(this).locks.axes(slot, isLocked, yLocked());
    }

    /** Locks the centre of mass in y, or unlocks it, as {@link #xLocked(boolean)} does in x. */
    public void yLocked(boolean isLocked) {
        pool.editor(this).locks.axes(slot, xLocked(), isLocked);
    }

    /**
     * Sets the shape; the centre of mass stays where it is. The mass follows from the new shape,
     * unless the definition stated a mass.
     *
     * @throws IllegalArgumentException when a dynamic body should get a {@code Chain}, or the mass
     *     or inertia would be out of its range
     * @throws IllegalStateException when the shape has a sensor and the effect {@code Sensors} is
     *     not declared
     */
    public void shape(Shape shape) {
        pool.editor(this).shape(slot, Require.present("RigidBody.shape", shape));
    }

    /**
     * Drives a kinematic body to a pose within a given time and stops it there. On the way it turns
     * at a constant rate, and its centre of mass moves along the matching arc, so that a door turns
     * about its hinge. The path is straight if the body does not turn or turns by more than half a
     * turn. Bodies that stand on it are carried along. Setting its velocity, spin, pose or type
     * ends the drive.
     *
     * <pre>{@code
     * RigidBody lift = pool.add(BodyDefinition.kinematic(Polygon.box(2, 0.2)));
     * lift.driveTo(0, 3, 0, 1.5); // 3 m up, in 1.5 s
     * }</pre>
     *
     * @param x world x of the centre of mass, m
     * @param y world y of the centre of mass, m, up
     * @param angle rad, counter-clockwise, within a million turns; ignored where {@code Rotation}
     *     is not declared
     * @param seconds duration from now, s of simulated time, positive
     * @throws IllegalArgumentException when a number is out of its range, the body is not
     *     kinematic, would have to move along a locked axis, or would have to be faster than light
     */
    public void driveTo(double x, double y, double angle, double seconds) {
        pool.editor(this).motion.driveTo(slot, x, y, angle, seconds);
    }

    /**
     * Stops a dynamic body and puts it to sleep where it is, even in mid-air, until something
     * touches it or it is woken. Has no effect on static and kinematic bodies.
     */
    public void sleep() {
        pool.editor(this).motion.sleep(slot);
    }

    /**
     * Takes the body out of the simulation until {@link #enable}: it does not move or collide, and
     * queries do not find it. Its state, velocity included, is kept. The bodies it touched wake.
     */
    public void disable() {
        pool.editor(this).disable(slot);
    }

    /** Brings a disabled body back into the simulation, awake. */
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

    /** The slot that the body has or, once removed, had; threads that do not step may ask too. */
    int everSlot() {
        int now = slot;
        return now >= 0 ? now : ~now;
    }

    void markRemoved() {
        slot = ~slot;
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
