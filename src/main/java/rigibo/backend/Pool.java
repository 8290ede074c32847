package rigibo.backend;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Aabb;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Shape;
import rigibo.backend.saved.SavedContact;
import rigibo.backend.saved.Snapshot;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.backend.setup.Require;
import rigibo.backend.step.StepPlan;
import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.DataStorage;
import rigibo.backend.storage.JointStore;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * A world of rigid bodies. It manages all bodies, their dynamics and every query about them. The
 * same calls give the same bits on every machine. Not thread-safe: one thread uses a pool at a
 * time.
 *
 * <pre>{@code
 * Pool world = new Pool(); // gravity, contacts, rotation, friction, restitution, sleep
 * world.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5));
 * RigidBody box = world.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 5));
 * while (box.isAwake()) {
 *     world.step(1.0 / 60);
 * }
 * }</pre>
 */
public final class Pool {

    /** Revision of the simulation, raised with every change of the bits that a pool goes on to. */
    public static final int REVISION = Snapshot.REVISION;

    /** Longest step accepted, s. */
    public static final double LONGEST_STEP = 10;

    /** Shortest step accepted, s: below it rates of change lose their meaning in doubles. */
    public static final double SHORTEST_STEP = 1e-9;

    /** Bodies or pairs that room is made for: columns of about a gigabyte. */
    private static final int MOST_ROOM = 1 << 22;

    private static final LongSupplier NO_CLOCK = () -> 0;

    private final DataStorage data;
    private final StepPlan plan;
    private final StepReport report;
    private final BodyEditor editor;

    /** Made when it is first asked: who never asks loads none of its classes. */
    private PoolQueries queries;

    private PoolCasts casts;

    /** Made when somebody asks, or edits a body that might touch others. */
    private PoolContacts contacts;

    /** Made when somebody asks. */
    private PoolHits hits;

    /** Made when somebody asks what sensors see, or edits a body that they may see. */
    private PoolSensors sensors;

    /** Asked of the effects once: a question that allocates nothing asks each time. */
    private boolean senses;

    /** Null where no joints are declared. */
    private PoolJoints joints;

    private final PoolTotals totals;
    private final BodyList bodies = new BodyList();
    private LongSupplier clock = NO_CLOCK;
    private double time;
    private final Busy busy = new Busy();

    /** A pool with the usual effects at {@link Accuracy#GAME}. */
    public Pool() {
        this(Effects.usual(), Accuracy.GAME);
    }

    /**
     * An empty pool.
     *
     * @param effects what is simulated; what is not declared costs nothing
     * @param accuracy how exactly
     */
    public Pool(Effects effects, Accuracy accuracy) {
        this(
                new DataStorage(Require.present("Pool.effects", effects)),
                effects,
                Require.present("Pool.accuracy", accuracy));
    }

    private Pool(DataStorage data, Effects effects, Accuracy accuracy) {
        this.data = data;
        plan = new StepPlan(data, effects, accuracy);
        report = new StepReport(this, data);
        editor = new BodyEditor(this, data, plan);
        totals = new PoolTotals(this, data);
        declare();
    }

    Pool(Snapshot snapshot) {
        this(snapshot.data, snapshot.effects, snapshot.accuracy);
        time = snapshot.time;
        editor.derive();
        for (int i = 0; i < snapshot.order.length; i++) {
            bodies.append(new RigidBody(this, snapshot.order[i], snapshot.names[i]));
        }
        if (joints != null) {
            joints.restore(snapshot.jointOrder);
        }
        for (SavedContact contact : snapshot.ended) {
            contacts().ended.restore(contact);
        }
    }

    /**
     * A pool that goes on as the one whose snapshot this is, to the last bit, on every machine. Its
     * bodies come in the same order and have the same names; the handles are new ones. It has no
     * clock, and its report is empty until it has made a step.
     *
     * @param snapshot as {@link #snapshot} wrote it
     * @throws IllegalArgumentException when it is cut short, altered, of another format or another
     *     {@link #REVISION}, states what no pool can be in, or declares an effect that holds a
     *     function of the caller's, which is named
     */
    public static Pool restore(byte[] snapshot) {
        return PoolSnapshot.restore(snapshot);
    }

    /**
     * Restores a snapshot with the caller's effects in place of those saved, functions and numbers
     * alike.
     *
     * @param snapshot as {@link #snapshot} wrote it
     * @param effects of the kinds that were declared when it was taken
     * @throws IllegalArgumentException as above, and when the kinds are not the same, naming the
     *     difference
     */
    public static Pool restore(byte[] snapshot, Effects effects) {
        return PoolSnapshot.restore(snapshot, effects);
    }

    /**
     * Adds a body.
     *
     * @throws IllegalArgumentException when the definition gives no finite mass or inertia
     */
    public RigidBody add(BodyDefinition definition) {
        Require.present("Pool.add definition", definition);
        busy.requireChangeable("add a body");
        return bodies.append(new RigidBody(this, editor.add(definition), definition.name()));
    }

    /**
     * Takes a body out, with its joints, and wakes what it touched; how many other bodies there are
     * takes no time.
     *
     * @throws IllegalArgumentException when the body is of another pool
     * @throws IllegalStateException when it was removed before
     */
    public void remove(RigidBody body) {
        BodyEditor bodyEditor = editor(body);
        if (joints != null) {
            joints.removeAllOf(body);
        }
        bodyEditor.remove(body.slot());
        bodies.drop(body);
        body.markRemoved();
    }

    /**
     * Joins two bodies, and wakes them.
     *
     * @throws IllegalStateException when the effect {@code Joints} is not declared
     * @throws IllegalArgumentException when a body, or a joint it couples, is of another pool
     */
    public Joint join(JointDefinition definition) {
        Require.present("Pool.join definition", definition);
        busy.requireChangeable("join bodies");
        if (joints == null) {
            throw new IllegalStateException(
                    "Pool.join needs the effect Joints, which is not declared");
        }
        return joints.join(definition);
    }

    /**
     * Ends a joint, with the gears that couple it, and wakes its bodies.
     *
     * @throws IllegalArgumentException when it is of another pool
     * @throws IllegalStateException when it was removed before, or broke
     */
    public void remove(Joint joint) {
        joinery(joint);
        joints.remove(joint);
    }

    /**
     * All joints in the order they were joined, none where {@code Joints} are not declared; a view
     * that cannot be changed through itself.
     */
    public List<Joint> joints() {
        return joints == null ? List.of() : joints.all();
    }

    /**
     * The joints that broke in the last step; a list of its own.
     *
     * @throws IllegalStateException when the effect {@code Joints} is not declared
     */
    public List<JointBreak> brokenJoints() {
        if (joints == null) {
            throw new IllegalStateException(
                    "Pool.brokenJoints needs the effect Joints, which is not declared");
        }
        return joints.broken();
    }

    /**
     * Makes room, so that columns need not double in the midst of play; changes nothing else.
     *
     * @param bodies at once, 0 to 4,194,304
     * @param pairs at once as {@link StepReport#pairs} counts them, 0 to 4,194,304
     * @throws IllegalArgumentException when one is out of its range
     */
    public void reserve(int bodies, int pairs) {
        Require.within("Pool.reserve bodies", bodies, 0, MOST_ROOM);
        Require.within("Pool.reserve pairs", pairs, 0, MOST_ROOM);
        busy.requireChangeable("make room");
        data.reserve(bodies, pairs);
    }

    /**
     * All bodies in the order they were added; a live view that cannot be changed through itself.
     * An iterator, a for-each loop or a stream over it that goes on after a body was added or
     * removed throws {@link java.util.ConcurrentModificationException} instead of skipping one,
     * even after the last but one or the last; {@code List.copyOf(pool.bodies())} can be gone
     * through whatever happens to the pool.
     */
    public List<RigidBody> bodies() {
        return bodies;
    }

    /**
     * Advances time.
     *
     * @param dt s, from 1e-9 to 10; a game's is 1/60
     * @return what the step did, overwritten by the next one
     * @throws IllegalArgumentException when dt is out of its range
     */
    public StepReport step(double dt) {
        Require.within("Pool.step dt", dt, SHORTEST_STEP, LONGEST_STEP, "s");
        busy.requireChangeable("step");
        busy.beginStep();
        data.time = time;
        try {
            plan.run(dt, clock);
        } finally {
            busy.endStep();
        }
        if (contacts != null) {
            contacts.ended.follow();
        }
        if (sensors != null) {
            sensors.follow();
        }
        if (joints != null) {
            joints.followBreaks();
        }
        time += dt;
        return report;
    }

    /** Simulated time since the pool was made, s. */
    public double time() {
        return time;
    }

    /** What the last step did. */
    public StepReport report() {
        return report;
    }

    /** How accurately it is simulated. */
    public Accuracy accuracy() {
        return plan.accuracy();
    }

    /** Changes the accuracy from the next step on; resting bodies stay at rest. */
    public void accuracy(Accuracy accuracy) {
        Require.present("Pool.accuracy", accuracy);
        busy.requireChangeable("change the accuracy");
        plan.compile(plan.effects(), accuracy);
    }

    /** What is simulated. */
    public Effects effects() {
        return plan.effects();
    }

    /**
     * Changes what is simulated from the next step on, and wakes every body. Where joints are no
     * longer declared they all end.
     */
    public void effects(Effects effects) {
        Require.present("Pool.effects", effects);
        busy.requireChangeable("change the effects");
        editor.effects(effects);
        declare();
    }

    private void declare() {
        senses = plan.effects().declares(Sensors.class);
        if (data.joints == null && joints != null) {
            joints.removeAll();
            joints = null;
        } else if (data.joints != null && joints == null) {
            joints = new PoolJoints(this, data, plan);
        }
    }

    /**
     * How many bits each body takes in the columns that the declared effects need; what they refer
     * to, its shape and its material, is not counted.
     */
    public int bitsPerBody() {
        return data.bodies.bitsPerBody();
    }

    /** The stages one step consists of and the columns it keeps, in words. */
    public String plan() {
        return plan.describe();
    }

    /** Hands in a clock that counts ns, so that reports tell the time of each stage. */
    public void clock(LongSupplier nanoseconds) {
        clock = Require.present("Pool.clock", nanoseconds);
    }

    /**
     * Whether two bodies touch as the last step left them; one that was placed, shaped or given
     * another type since touches nothing. Refuses bodies as {@link #remove} does.
     */
    public boolean touching(RigidBody a, RigidBody b) {
        return queries().touching(own(a).slot(), own(b).slot());
    }

    /**
     * The contacts of the last step, at most one for any two shapes; a list of its own. It tells
     * the same until the next step, whatever is edited.
     */
    public List<ContactEvent> contactEvents() {
        return contacts().list();
    }

    /**
     * Shows the contacts of {@link #contactEvents} one by one and allocates nothing. Meanwhile the
     * pool makes no step and refuses to be changed with {@link IllegalStateException}.
     *
     * @param visitor is handed one object again and again, whose contents hold until it returns
     * @throws IllegalStateException when called within a step
     */
    public void forEachContact(Consumer<? super ContactView> visitor) {
        Require.present("Pool.forEachContact visitor", visitor);
        busy.requireBetweenSteps("visit contacts");
        contacts().forEach(visitor);
    }

    /**
     * The impacts of the last step; a list of its own. Those of flight come first, in the order of
     * time. One whose body is removed before the next step is not told any more.
     */
    public List<HitEvent> hits() {
        return shownHits().list();
    }

    /**
     * Shows what {@link #hits} tells one by one and allocates nothing. Meanwhile the pool makes no
     * step and refuses to be changed with {@link IllegalStateException}.
     *
     * @param visitor is handed one object again and again, whose contents hold until it returns
     * @throws IllegalStateException when called within a step
     */
    public void forEachHit(Consumer<? super HitView> visitor) {
        Require.present("Pool.forEachHit visitor", visitor);
        busy.requireBetweenSteps("visit hits");
        shownHits().forEach(visitor);
    }

    /**
     * What sensors saw in the last step; a list of its own.
     *
     * @throws IllegalStateException when the effect {@code Sensors} is not declared
     */
    public List<SensorEvent> sensorEvents() {
        return sensors("sensorEvents").list();
    }

    /**
     * Shows what {@link #sensorEvents} tells one by one and allocates nothing. Meanwhile the pool
     * makes no step and refuses to be changed with {@link IllegalStateException}.
     *
     * @param reader is handed one object again and again, whose contents hold until it returns
     * @throws IllegalStateException when called within a step, and when the effect {@code Sensors}
     *     is not declared
     */
    public void forEachSensorEvent(Consumer<? super SensorView> reader) {
        Require.present("Pool.forEachSensorEvent reader", reader);
        busy.requireBetweenSteps("read sensors");
        sensors("forEachSensorEvent").forEach(reader);
    }

    /**
     * The bodies that the last step left inside of any sensor of a body, each once. Refuses bodies
     * as {@link #remove} does.
     *
     * @throws IllegalStateException when the effect {@code Sensors} is not declared
     */
    public List<RigidBody> inside(RigidBody sensor) {
        return List.copyOf(sensors("inside").inside(own(sensor).slot()));
    }

    /**
     * Whether the last step left a body inside of any sensor of another one. Refuses as {@link
     * #inside} does.
     */
    public boolean isInside(RigidBody sensor, RigidBody visitor) {
        return sensors("isInside").inside(own(sensor).slot()).contains(own(visitor));
    }

    /**
     * The body under a point, the last added of several. Here and below every body is asked where
     * {@code Contacts} are not declared: nobody keeps a tree of boxes.
     *
     * @param x world x, m
     * @param y world y, m, up
     * @throws IllegalArgumentException when one is not finite
     */
    public Optional<RigidBody> bodyAt(double x, double y) {
        return queries().bodyAt(x, y);
    }

    /**
     * The first body that a ray meets: the first added of several met in one point. A ray that
     * starts inside a body does not meet that one. It costs by the fixtures along its way to there.
     *
     * @param fromX start, m
     * @param fromY start, m
     * @param toX end, m
     * @param toY end, m
     * @throws IllegalArgumentException when one is not finite
     */
    public Optional<RayHit> rayCast(double fromX, double fromY, double toX, double toY) {
        return queries().rayCast(fromX, fromY, toX, toY, null);
    }

    /**
     * The first body that a ray meets of those that a filter meets; otherwise as {@link
     * #rayCast(double, double, double, double)}.
     */
    public Optional<RayHit> rayCast(
            double fromX, double fromY, double toX, double toY, Filter filter) {
        Require.present("Pool.rayCast filter", filter);
        return queries().rayCast(fromX, fromY, toX, toY, filter);
    }

    /**
     * All bodies that a ray enters and a filter meets, each once, in their order on its way: those
     * entered in one point as they were added. It costs by the fixtures along its way.
     *
     * @param fromX start, m
     * @param fromY start, m
     * @param toX end, m
     * @param toY end, m
     * @throws IllegalArgumentException when one is not finite
     */
    public List<RayHit> rayCastAll(
            double fromX, double fromY, double toX, double toY, Filter filter) {
        return casts().rayCastAll(fromX, fromY, toX, toY, filter);
    }

    /**
     * The first body that a shape meets on a straight way, without turning: the one added first of
     * several met at once. The hit tells the point and the outward normal of the body met. A shape
     * that starts in one and goes deeper meets it at once; one that leaves it does not, nor does
     * one that comes out of the matter of a chain.
     *
     * @param shape may be a compound
     * @param from where it starts
     * @param dx way to the right, m
     * @param dy way up, m
     * @param filter whom it may meet
     * @throws IllegalArgumentException when the way is not finite
     */
    public Optional<RayHit> cast(Shape shape, Placement from, double dx, double dy, Filter filter) {
        return casts().cast(shape, from, dx, dy, filter);
    }

    /**
     * Hands every body that a shape reaches into or touches to a visitor, in order of slots; of a
     * chain the edges are asked, whose matter has no end.
     */
    public void overlapping(Shape shape, Placement at, Filter filter, Consumer<RigidBody> visitor) {
        Require.present("Pool.overlapping visitor", visitor);
        casts().overlapping(shape, at, filter).forEach(visitor);
    }

    /**
     * The nearest point of any body that a filter meets: that of the body added first of several.
     *
     * @param x world x, m
     * @param y world y, m, up
     * @param within how far away it may be, m, 0 or more
     * @throws IllegalArgumentException when a number is not finite
     */
    public Optional<NearestPoint> nearest(double x, double y, double within, Filter filter) {
        return casts().nearest(x, y, within, filter);
    }

    /**
     * Strikes all dynamic bodies that a blast reaches, and wakes them.
     *
     * @throws IllegalArgumentException when a body would become faster than light: then none is
     *     struck
     */
    public void explode(Explosion explosion) {
        Require.present("Pool.explode explosion", explosion);
        busy.requireChangeable("explode");
        new Blast(data.bodies, queries(), editor).of(explosion);
    }

    /**
     * Hands every body whose shape reaches into a box to a visitor, in the order of their slots.
     */
    public void overlapping(Aabb box, Consumer<RigidBody> visitor) {
        Require.present("Pool.overlapping box", box);
        queries().overlapping(box).forEach(visitor);
    }

    /**
     * All that the future depends on, as bytes for {@link #restore}: bodies with their names and
     * order, contacts with what they carry, time, effects and accuracy. Of an effect that holds a
     * function only the kind is written.
     *
     * @throws IllegalStateException when called within a step
     */
    public byte[] snapshot() {
        busy.requireBetweenSteps("take a snapshot");
        return PoolSnapshot.encode(this, data);
    }

    /**
     * A 64-bit hash of every bit of the state that the future depends on: pools with equal effects
     * and accuracy whose hashes are equal go on equally.
     */
    public long stateHash() {
        return totals.stateHash();
    }

    /** J of motion and rotation of all dynamic bodies. */
    public double kineticEnergy() {
        return totals.kineticEnergy();
    }

    /** J of all dynamic bodies in the declared gravity; 0 at the world's origin. */
    public double potentialEnergy() {
        return totals.potentialEnergy();
    }

    /** N·s to the right, of all dynamic bodies. */
    public double momentumX() {
        return totals.momentumX();
    }

    /** N·s up, of all dynamic bodies. */
    public double momentumY() {
        return totals.momentumY();
    }

    /** kg·m²/s about the world's origin, counter-clockwise, of all dynamic bodies. */
    public double angularMomentum() {
        return totals.angularMomentum();
    }

    PoolQueries queries() {
        if (queries == null) {
            queries = new PoolQueries(this, data, plan);
        }
        return queries;
    }

    private PoolCasts casts() {
        if (casts == null) {
            casts = new PoolCasts(this, plan, queries());
        }
        return casts;
    }

    PoolContacts contacts() {
        if (contacts == null) {
            contacts = new PoolContacts(this, data, busy);
        }
        return contacts;
    }

    private PoolHits shownHits() {
        if (hits == null) {
            hits = new PoolHits(this, data, busy);
        }
        return hits;
    }

    PoolSensors sensors() {
        if (sensors == null) {
            sensors = new PoolSensors(this, data, busy);
        }
        return sensors;
    }

    /** Whom a caller asks about sensors; an empty answer would hide that nobody looks. */
    private PoolSensors sensors(String question) {
        if (!senses) {
            throw new IllegalStateException(
                    "Pool." + question + " needs the effect Sensors, which is not declared");
        }
        return sensors();
    }

    List<SavedContact> savedContacts() {
        return contacts == null ? List.of() : contacts.ended.saved();
    }

    void sizeFixture(int slot, Aabb into) {
        queries().sizeFixture(slot, into);
    }

    /**
     * What changes a body; refuses bodies of other pools, removed ones, and calls within a step.
     */
    BodyEditor editor(RigidBody body) {
        own(body);
        busy.requireChangeable("change a body");
        return editor;
    }

    /** What reads a body; to change one, say which. */
    BodyEditor editor() {
        return editor;
    }

    Bodies columns() {
        return data.bodies;
    }

    RigidBody handle(int slot) {
        return bodies.atSlot(slot);
    }

    /** What changes a joint; refuses as {@link #editor(RigidBody)} does. */
    Joinery joinery(Joint joint) {
        Require.present("joint", joint).requireAlive();
        busy.requireChangeable("change a joint");
        if (joints == null || joint.pool() != this) {
            throw new IllegalArgumentException(joint + " belongs to another pool");
        }
        return joints.joinery();
    }

    /** What reads a joint. */
    Joinery joinery() {
        return joints.joinery();
    }

    JointStore jointColumns() {
        return data.joints;
    }

    Joint joint(int slot) {
        return joints.atSlot(slot);
    }

    int[] jointOrder() {
        return joints == null ? new int[0] : joints.order();
    }

    List<Joint> jointsOf(int body) {
        return joints == null ? List.of() : joints.of(body);
    }

    void requireOwn(RigidBody body) {
        own(body);
    }

    private RigidBody own(RigidBody body) {
        Require.present("body", body).requireAlive();
        if (body.pool() != this) {
            throw new IllegalArgumentException(body + " belongs to another pool");
        }
        return body;
    }
}
