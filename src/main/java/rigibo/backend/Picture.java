package rigibo.backend;

import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.Bodies;
import rigibo.backend.team.Lease;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;

/**
 * A pool as a step left it, for the one thread that took it from {@link SharedView#read}. It does
 * not change while another thread steps and edits the pool. Its queries give the answers that those
 * of {@link Pool} would have given right after that step. They return the pool's own handles, which
 * tell the present state. So ask the picture, not the handle, where a body was.
 *
 * <p>Every method throws {@link IllegalStateException} on another thread, and all but {@link
 * #close} do after the picture was closed. Methods that take a body throw {@link
 * IllegalArgumentException} if the picture does not show it, see {@link #shows}.
 *
 * <pre>{@code
 * try (Picture picture = pool.shared().read()) {
 *     for (RigidBody body : picture.bodies()) {
 *         System.out.println(picture.time() + " s: " + picture.x(body) + " " + picture.y(body));
 *     }
 * }
 * }</pre>
 */
public final class Picture implements AutoCloseable {

    private final Pool pool;
    private final Lease<CopiedState> lease;
    private final Busy busy = new Busy();

    /** Made at the first question that needs it. */
    private CopyReader reader;

    private PoolQueries queries;
    private PoolCasts casts;
    private ContactVisits contacts;

    Picture(Pool pool, Lease<CopiedState> lease) {
        this.pool = pool;
        this.lease = lease;
    }

    /** Number of steps that were finished since the pool was asked to share. */
    public long step() {
        return lease.picture().step;
    }

    /** Simulated time since the pool was made, s. */
    public double time() {
        return lease.picture().time;
    }

    /** All bodies in the order they were added, as a new list. */
    public List<RigidBody> bodies() {
        return lease.picture().roll.all();
    }

    /** Whether a body was in the pool when the picture was made. */
    public boolean shows(RigidBody body) {
        return lease.picture().roll.holds(Require.present("body", body));
    }

    /** World x of the centre of mass, m. */
    public double x(RigidBody body) {
        return columnsOf(body).x[body.everSlot()];
    }

    /** World y of the centre of mass, m, up. */
    public double y(RigidBody body) {
        return columnsOf(body).y[body.everSlot()];
    }

    /** Angle in rad, counter-clockwise, not wrapped. */
    public double angle(RigidBody body) {
        return columnsOf(body).angle[body.everSlot()];
    }

    /** Velocity of the centre of mass to the right, m/s. */
    public double velocityX(RigidBody body) {
        return columnsOf(body).velocityX[body.everSlot()];
    }

    /** Velocity of the centre of mass upwards, m/s. */
    public double velocityY(RigidBody body) {
        return columnsOf(body).velocityY[body.everSlot()];
    }

    /** Angular velocity in rad/s, counter-clockwise; 0 where rotation is not declared. */
    public double angularVelocity(RigidBody body) {
        return columnsOf(body).spinOf(body.everSlot());
    }

    /** Whether the body was dynamic, static or kinematic. */
    public BodyType type(RigidBody body) {
        return columnsOf(body).type[body.everSlot()];
    }

    /** The shape, whose centre of mass lies at (x, y). */
    public Shape shape(RigidBody body) {
        return columnsOf(body).shape[body.everSlot()];
    }

    /** Whether the body was awake; a static body never is. */
    public boolean isAwake(RigidBody body) {
        return columnsOf(body).awake[body.everSlot()] && type(body) != BodyType.STATIC;
    }

    /** As {@link Pool#bodyAt}. */
    public Optional<RigidBody> bodyAt(double x, double y) {
        return queries().bodyAt(x, y);
    }

    /** As {@link Pool#rayCast(double, double, double, double)}. */
    public Optional<RayHit> rayCast(double fromX, double fromY, double toX, double toY) {
        return queries().rayCast(fromX, fromY, toX, toY, null);
    }

    /** As {@link Pool#rayCast(double, double, double, double, Filter)}. */
    public Optional<RayHit> rayCast(
            double fromX, double fromY, double toX, double toY, Filter filter) {
        Require.present("Picture.rayCast filter", filter);
        return queries().rayCast(fromX, fromY, toX, toY, filter);
    }

    /** As {@link Pool#rayCastAll}. */
    public List<RayHit> rayCastAll(
            double fromX, double fromY, double toX, double toY, Filter filter) {
        return casts().rayCastAll(fromX, fromY, toX, toY, filter);
    }

    /** As {@link Pool#cast}. */
    public Optional<RayHit> cast(Shape shape, Placement from, double dx, double dy, Filter filter) {
        return casts().cast(shape, from, dx, dy, filter);
    }

    /** As {@link Pool#nearest}. */
    public Optional<NearestPoint> nearest(double x, double y, double within, Filter filter) {
        return casts().nearest(x, y, within, filter);
    }

    /** As {@link Pool#overlapping(Aabb, Consumer)}. */
    public void overlapping(Aabb box, Consumer<RigidBody> visitor) {
        Require.present("Picture.overlapping box", box);
        Require.present("Picture.overlapping visitor", visitor);
        queries().overlapping(box).forEach(visitor);
    }

    /** As {@link Pool#overlapping(Shape, Placement, Filter, Consumer)}. */
    public void overlapping(Shape shape, Placement at, Filter filter, Consumer<RigidBody> visitor) {
        Require.present("Picture.overlapping visitor", visitor);
        casts().overlapping(shape, at, filter).forEach(visitor);
    }

    /** Whether two bodies touched at the end of the step. */
    public boolean touching(RigidBody a, RigidBody b) {
        requireShown(a);
        requireShown(b);
        return queries().touching(a.everSlot(), b.everSlot());
    }

    /** The contacts of the step, as {@link Pool#contactEvents}; some may name bodies not shown. */
    public List<ContactEvent> contactEvents() {
        CopiedState state = lease.picture();
        return contacts().list(state.cut, state.ended);
    }

    /**
     * Calls a visitor with each contact of {@link #contactEvents}, without allocating. Until it
     * returns, the picture cannot be closed.
     *
     * @param visitor is given one and the same object for every contact, valid only during the call
     */
    public void forEachContact(Consumer<? super ContactView> visitor) {
        Require.present("Picture.forEachContact visitor", visitor);
        CopiedState state = lease.picture();
        contacts().forEach(state.cut, state.ended, visitor);
    }

    /**
     * Gives the picture back, so that a later step may reuse its memory.
     *
     * @throws IllegalStateException when it was already closed, or when called by another thread or
     *     from a visitor of contacts
     */
    @Override
    public void close() {
        lease.picture();
        busy.requireChangeable("close the picture");
        lease.close();
    }

    private Bodies columnsOf(RigidBody body) {
        requireShown(body);
        return lease.picture().columns.bodies;
    }

    private void requireShown(RigidBody body) {
        if (shows(body)) {
            return;
        }
        String called = body.name().isEmpty() ? "the body" : "the body '" + body.name() + "'";
        throw new IllegalArgumentException(
                body.pool() == pool
                        ? called + " was not in the pool in step " + step() + ", which is shown"
                        : called + " belongs to another pool");
    }

    private CopyReader reader() {
        CopiedState state = lease.picture();
        if (reader == null) {
            reader = new CopyReader(state);
        }
        return reader;
    }

    private PoolQueries queries() {
        CopyReader read = reader();
        if (queries == null) {
            queries = new PoolQueries(read);
        }
        return queries;
    }

    private PoolCasts casts() {
        CopyReader read = reader();
        if (casts == null) {
            casts = new PoolCasts(read, queries());
        }
        return casts;
    }

    private ContactVisits contacts() {
        CopyReader read = reader();
        if (contacts == null) {
            contacts = new ContactVisits(read, busy);
        }
        return contacts;
    }
}
