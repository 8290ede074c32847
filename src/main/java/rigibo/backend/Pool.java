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
import rigibo.backend.team.Team;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * A world of rigid bodies: it holds the bodies and joints, steps them through time and answers
 * queries. The same calls give the same bits on every machine. Not thread-safe: only one thread may
 * use a pool at a time, though {@link #workers(int)} lets a step use several cores, and {@link
 * #shared} lets other threads query the last finished step. All units are SI, y points up, and
 * angles are counter-clockwise.
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
public final class Pool implements AutoCloseable {

    /** Revision of the simulation: raised with every change that alters the bits of results. */
    public static final int REVISION = Snapshot.REVISION;

    /** Longest step accepted, s. */
    public static final double LONGEST_STEP = 10;

    /** Shortest step accepted, s; changes over a shorter step drown in the round-off of doubles. */
    public static final double SHORTEST_STEP = 1e-9;

    /** Most workers that {@link #workers(int)} accepts. */
    public static final int MOST_WORKERS = Team.MOST;

    /** Most bodies or pairs that {@link #reserve} accepts: their columns take about 1 GB. */
    private static final int MOST_ROOM = 1 << 22;

    private static final LongSupplier NO_CLOCK = () -> 0;

    private final DataStorage data;
    private final StepPlan plan;
    private final StepReport report;
    private final BodyEditor editor;

    /** Made at the first query, so that a program without queries loads none of its classes. */
    private LiveState live;

    private PoolQueries queries;

    private PoolCasts casts;

    /** Made when contacts are read, or when a body that might touch others is edited. */
    private PoolContacts contacts;

    /** Made when impacts are read. */
    private PoolHits hits;

    /** Made when sensors are read, or when a body that they may see is edited. */
    private PoolSensors sensors;

    /**
     * Whether {@code Sensors} is declared; cached, since looking it up in the effects allocates.
     */
    private boolean senses;

    /** Null while {@code Joints} is not declared. */
    private PoolJoints joints;

    /** Null while nobody asked to share. */
    private SharedView shared;

    private final PoolTotals totals;
    private final PoolWorkers workers = new PoolWorkers();
    private final BodyList bodies = new BodyList();
    private LongSupplier clock = NO_CLOCK;
    private double time;
    private final Busy busy = new Busy();

    /** An empty pool with {@link Effects#usual} at {@link Accuracy#GAME}. */
    public Pool() {
        this(Effects.usual(), Accuracy.GAME);
    }

    /**
     * An empty pool.
     *
     * @param effects what is simulated; an effect that is not declared costs nothing
     * @param accuracy how exactly it is simulated
     * @throws IllegalArgumentException when either is null
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
     * Restores a pool from a snapshot. On every machine it continues exactly, to the last bit, as
     * the original pool does. Bodies keep their order and names but get new handles. The new pool
     * has no clock, and its report is empty until its first step.
     *
     * @param snapshot bytes from {@link #snapshot}
     * @throws IllegalArgumentException when the snapshot is truncated, altered, of another format
     *     or another {@link #REVISION}, holds a state that no pool can have, or declares an effect
     *     that holds a caller's function (the message names the effect)
     */
    public static Pool restore(byte[] snapshot) {
        return PoolSnapshot.restore(snapshot);
    }

    /**
     * Restores a pool from a snapshot, with the given effects in place of the saved ones: both
     * their functions and their parameters are taken from the argument.
     *
     * @param snapshot bytes from {@link #snapshot}
     * @param effects the same kinds of effects that were declared when the snapshot was taken
     * @throws IllegalArgumentException as {@link #restore(byte[])} does, except for functions; and
     *     when the kinds of effects differ, naming the difference
     */
    public static Pool restore(byte[] snapshot, Effects effects) {
        return PoolSnapshot.restore(snapshot, effects);
    }

    /**
     * Adds a body and returns its handle.
     *
     * @throws IllegalArgumentException when mass or inertia of the definition is out of its range
     * @throws IllegalStateException when called within a step or from a visitor, or when the body
     *     has a sensor and the effect {@code Sensors} is not declared
     */
    public RigidBody add(BodyDefinition definition) {
        Require.present("Pool.add definition", definition);
        busy.requireChangeable("add a body");
        return bodies.append(new RigidBody(this, editor.add(definition), definition.name()));
    }

    /**
     * Removes a body and its joints, and wakes the bodies it touched. The cost does not depend on
     * how many bodies the pool holds.
     *
     * @throws IllegalArgumentException when the body belongs to another pool
     * @throws IllegalStateException when it was already removed, or when called within a step or
     *     from a visitor
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
     * Joins two bodies and wakes them.
     *
     * @throws IllegalStateException when the effect {@code Joints} is not declared, or when called
     *     within a step or from a visitor
     * @throws IllegalArgumentException when a body, or a joint that a gear couples, belongs to
     *     another pool
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
     * Removes a joint and the gears that couple it, and wakes its bodies.
     *
     * @throws IllegalArgumentException when the joint belongs to another pool
     * @throws IllegalStateException when it was already removed or is broken, or when called within
     *     a step or from a visitor
     */
    public void remove(Joint joint) {
        joinery(joint);
        joints.remove(joint);
    }

    /**
     * All joints in the order they were joined, as a live read-only view; empty while {@code
     * Joints} is not declared.
     */
    public List<Joint> joints() {
        return joints == null ? List.of() : joints.all();
    }

    /**
     * The joints that broke in the last step, as a new list.
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
     * Allocates columns in advance, so that no step has to grow them. It changes nothing else.
     *
     * @param bodies number of bodies at the same time, 0 to 4,194,304
     * @param pairs number of pairs at the same time, counted as {@link StepReport#pairs} does, 0 to
     *     4,194,304
     * @throws IllegalArgumentException when a number is out of its range
     */
    public void reserve(int bodies, int pairs) {
        Require.within("Pool.reserve bodies", bodies, 0, MOST_ROOM);
        Require.within("Pool.reserve pairs", pairs, 0, MOST_ROOM);
        busy.requireChangeable("make room");
        data.reserve(bodies, pairs);
    }

    /**
     * All bodies in the order they were added, as a live read-only view. If a body is added or
     * removed while an iterator, a for-each loop or a stream runs over the view, it throws {@link
     * java.util.ConcurrentModificationException}, even at the last element, rather than skip a
     * body. To add or remove bodies in a loop, iterate over {@code List.copyOf(pool.bodies())}.
     */
    public List<RigidBody> bodies() {
        return bodies;
    }

    /**
     * Advances the simulation by one step.
     *
     * @param dt length of the step in s, 1e-9 to 10; a game uses 1/60
     * @return what the step did; the next step overwrites this object
     * @throws IllegalArgumentException when dt is out of its range
     * @throws IllegalStateException when called within a step or from a visitor
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
        if (shared != null) {
            shared.stepped();
        }
        return report;
    }

    /** Simulated time since the pool was made, s. */
    public double time() {
        return time;
    }

    /** What the last step did; the next step overwrites this object. */
    public StepReport report() {
        return report;
    }

    /** How accurately the pool simulates. */
    public Accuracy accuracy() {
        return plan.accuracy();
    }

    /** Sets the accuracy from the next step on; resting bodies stay at rest. */
    public void accuracy(Accuracy accuracy) {
        Require.present("Pool.accuracy", accuracy);
        busy.requireChangeable("change the accuracy");
        plan.compile(plan.effects(), accuracy);
    }

    /**
     * The number of workers that share a step: 1 unless {@link #workers(int)} or {@link
     * #rehearse(int)} said otherwise.
     */
    public int workers() {
        return workers.count();
    }

    /**
     * Sets the number of workers that share a step, the thread that steps among them. The same
     * calls give the same bits for any number. More workers than cores are allowed but only slow a
     * step down. One worker makes steps in which there is little to share. Workers share the narrow
     * phase, the islands, and the contacts of large islands. They do not share flight or the broad
     * phase. Where a force varies along the path or a body has several parts, islands are solved
     * one after the other.
     *
     * @param count 1 to 64; the other workers are daemon threads, parked between steps
     * @throws IllegalArgumentException when the count is out of its range
     * @throws IllegalStateException when called within a step or from a visitor
     */
    public void workers(int count) {
        Require.within("Pool.workers", count, 1, MOST_WORKERS);
        busy.requireChangeable("change the number of workers");
        if (!workers.are(count, false)) {
            plan.share(workers.hire(count));
        }
    }

    /**
     * Rehearses a step with workers, to find out what they would bring on a machine with a core for
     * each. From now on the thread that steps does the work of all of them, one after the other,
     * with the same bits. {@link StepReport#spared()} then tells how much earlier a step would have
     * ended. Real workers save less, since threads have to wake up and memory moves from core to
     * core. {@link #workers(int)} ends the rehearsal.
     *
     * @param count 1 to 64
     * @throws IllegalArgumentException when the count is out of its range
     * @throws IllegalStateException when called within a step or from a visitor
     */
    public void rehearse(int count) {
        Require.within("Pool.rehearse", count, 1, MOST_WORKERS);
        busy.requireChangeable("rehearse with workers");
        if (!workers.are(count, true)) {
            plan.share(workers.rehearse(count));
        }
    }

    /**
     * Shares the pool with other threads: from now on they may query the last finished step while
     * the next one runs. Call it from the thread that uses the pool, and hand the view to the
     * others. Until the first call, sharing costs nothing.
     *
     * @return the same view at every call, until the pool is closed
     * @throws IllegalStateException when called first within a step
     */
    public SharedView shared() {
        if (shared == null) {
            busy.requireBetweenSteps("begin to share");
            shared = new SharedView(this, live(), bodies, busy);
        }
        return shared;
    }

    /**
     * Ends the threads of other workers and the shared view. The pool stays usable, with one worker
     * and without pictures. The threads also end once nothing refers to the pool any more.
     *
     * @throws IllegalStateException when called within a step or from a visitor
     */
    @Override
    public void close() {
        workers(1);
        if (shared != null) {
            shared.end();
            shared = null;
        }
    }

    /** The declared effects: what the pool simulates. */
    public Effects effects() {
        return plan.effects();
    }

    /**
     * Sets the declared effects from the next step on and wakes every body. If {@code Joints} is no
     * longer declared, all joints are removed.
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
     * Memory of each body in bits, in the columns that the declared effects need. The objects that
     * columns refer to (shapes, materials) are not counted.
     */
    public int bitsPerBody() {
        return data.bodies.bitsPerBody();
    }

    /** The stages of a step and the columns of a body, in words, for reading. */
    public String plan() {
        return plan.describe();
    }

    /** Sets a clock that counts nanoseconds; reports then tell the time of each stage. */
    public void clock(LongSupplier nanoseconds) {
        clock = Require.present("Pool.clock", nanoseconds);
    }

    /**
     * Whether two bodies touched at the end of the last step. A body that has since been moved, or
     * been given another shape or type, counts as touching nothing.
     *
     * @throws IllegalArgumentException when a body belongs to another pool
     * @throws IllegalStateException when a body was removed
     */
    public boolean touching(RigidBody a, RigidBody b) {
        return queries().touching(own(a).slot(), own(b).slot());
    }

    /**
     * The contacts of the last step, as a new list: at most one for any two shapes. Edits between
     * steps do not change them.
     */
    public List<ContactEvent> contactEvents() {
        return contacts().list();
    }

    /**
     * Calls a visitor with each contact of {@link #contactEvents}, without allocating. Until it
     * returns, the pool refuses steps and changes with {@link IllegalStateException}.
     *
     * @param visitor is given one and the same object for every contact, valid only during the call
     * @throws IllegalStateException when called within a step
     */
    public void forEachContact(Consumer<? super ContactView> visitor) {
        Require.present("Pool.forEachContact visitor", visitor);
        busy.requireBetweenSteps("visit contacts");
        contacts().forEach(visitor);
    }

    /**
     * The impacts of the last step, as a new list: first those of bodies in flight, in the order of
     * time, then those inside piles. Impacts of a body that was removed since are left out.
     */
    public List<HitEvent> hits() {
        return shownHits().list();
    }

    /**
     * Calls a visitor with each impact of {@link #hits}, without allocating. Until it returns, the
     * pool refuses steps and changes with {@link IllegalStateException}.
     *
     * @param visitor is given one and the same object for every impact, valid only during the call
     * @throws IllegalStateException when called within a step
     */
    public void forEachHit(Consumer<? super HitView> visitor) {
        Require.present("Pool.forEachHit visitor", visitor);
        busy.requireBetweenSteps("visit hits");
        shownHits().forEach(visitor);
    }

    /**
     * What sensors saw in the last step, as a new list.
     *
     * @throws IllegalStateException when the effect {@code Sensors} is not declared
     */
    public List<SensorEvent> sensorEvents() {
        return sensors("sensorEvents").list();
    }

    /**
     * Calls a reader with each event of {@link #sensorEvents}, without allocating. Until it
     * returns, the pool refuses steps and changes with {@link IllegalStateException}.
     *
     * @param reader is given one and the same object for every event, valid only during the call
     * @throws IllegalStateException when called within a step, and when the effect {@code Sensors}
     *     is not declared
     */
    public void forEachSensorEvent(Consumer<? super SensorView> reader) {
        Require.present("Pool.forEachSensorEvent reader", reader);
        busy.requireBetweenSteps("read sensors");
        sensors("forEachSensorEvent").forEach(reader);
    }

    /**
     * The bodies that were inside any sensor of the given body at the end of the last step, each
     * once.
     *
     * @throws IllegalArgumentException when the body belongs to another pool
     * @throws IllegalStateException when it was removed, or the effect {@code Sensors} is not
     *     declared
     */
    public List<RigidBody> inside(RigidBody sensor) {
        return List.copyOf(sensors("inside").inside(own(sensor).slot()));
    }

    /**
     * Whether one body was inside any sensor of another at the end of the last step.
     *
     * @param sensor the body with the sensors
     * @param visitor the body that may be inside
     * @throws IllegalArgumentException when a body belongs to another pool
     * @throws IllegalStateException when a body was removed, or the effect {@code Sensors} is not
     *     declared
     */
    public boolean isInside(RigidBody sensor, RigidBody visitor) {
        return sensors("isInside").inside(own(sensor).slot()).contains(own(visitor));
    }

    /**
     * Draws all layers of the pool by the means of the caller; see {@link DebugDraw}. Until it
     * returns, the pool refuses steps and changes with {@link IllegalStateException}.
     *
     * @throws IllegalStateException when called within a step
     */
    public void draw(DebugDraw pen) {
        draw(pen, DebugDraw.Layer.values());
    }

    /**
     * Draws some layers of the pool; otherwise as {@link #draw(DebugDraw)}.
     *
     * @param layers in the order in which they are drawn
     */
    public void draw(DebugDraw pen, DebugDraw.Layer... layers) {
        Require.present("Pool.draw pen", pen);
        Require.present("Pool.draw layers", layers);
        busy.requireBetweenSteps("draw");
        busy.beginVisit();
        try {
            PoolDrawing drawing = new PoolDrawing(this, pen);
            for (DebugDraw.Layer layer : layers) {
                drawing.draw(Require.present("Pool.draw layer", layer));
            }
        } finally {
            busy.endVisit();
        }
    }

    /**
     * The body that contains a point; of several, the one added last. Without {@code Contacts}
     * there is no tree of fixtures, so this and the queries below check every body.
     *
     * @param x world x, m
     * @param y world y, m, up
     * @throws IllegalArgumentException when one is not finite
     */
    public Optional<RigidBody> bodyAt(double x, double y) {
        return queries().bodyAt(x, y);
    }

    /**
     * The first body that a ray hits; of several hit at the same point, the one added first. A ray
     * that starts inside a body does not hit that body. The cost grows with the number of fixtures
     * between the start and the hit.
     *
     * @param fromX world x of the start, m
     * @param fromY world y of the start, m
     * @param toX world x of the end, m
     * @param toY world y of the end, m
     * @throws IllegalArgumentException when a coordinate is not finite
     */
    public Optional<RayHit> rayCast(double fromX, double fromY, double toX, double toY) {
        return queries().rayCast(fromX, fromY, toX, toY, null);
    }

    /**
     * The first body that a ray hits among those that the filter meets; otherwise as {@link
     * #rayCast(double, double, double, double)}.
     */
    public Optional<RayHit> rayCast(
            double fromX, double fromY, double toX, double toY, Filter filter) {
        Require.present("Pool.rayCast filter", filter);
        return queries().rayCast(fromX, fromY, toX, toY, filter);
    }

    /**
     * All bodies that a ray enters and the filter meets, each once, in the order along the ray;
     * bodies entered at the same point come in the order they were added. The cost grows with the
     * number of fixtures along the ray.
     *
     * @param fromX world x of the start, m
     * @param fromY world y of the start, m
     * @param toX world x of the end, m
     * @param toY world y of the end, m
     * @throws IllegalArgumentException when a coordinate is not finite
     */
    public List<RayHit> rayCastAll(
            double fromX, double fromY, double toX, double toY, Filter filter) {
        return casts().rayCastAll(fromX, fromY, toX, toY, filter);
    }

    /**
     * Sweeps a shape along a straight line without turning it and returns the first body that it
     * hits; of several hit at the same time, the one added first. The hit holds the point and the
     * outward normal of the body that was hit. A shape that starts in overlap with a body hits it
     * at once if the sweep deepens the overlap, and does not hit it if the sweep leads out of it. A
     * shape that comes out of the solid side of a chain does not hit the chain.
     *
     * @param shape any shape, compounds included
     * @param from the pose where the sweep starts
     * @param dx displacement to the right, m
     * @param dy displacement up, m
     * @param filter which bodies the shape can hit
     * @throws IllegalArgumentException when the displacement is not finite
     */
    public Optional<RayHit> cast(Shape shape, Placement from, double dx, double dy, Filter filter) {
        return casts().cast(shape, from, dx, dy, filter);
    }

    /**
     * Calls a visitor with every body that a shape overlaps or touches, in a fixed order. Of a
     * chain only the edges count: the solid side behind them has no end.
     *
     * @param shape any shape, compounds included
     * @param at its pose
     * @param filter which bodies are looked for
     * @param visitor is given each body once
     */
    public void overlapping(Shape shape, Placement at, Filter filter, Consumer<RigidBody> visitor) {
        Require.present("Pool.overlapping visitor", visitor);
        casts().overlapping(shape, at, filter).forEach(visitor);
    }

    /**
     * The nearest point of any body that the filter meets; of several bodies equally near, the one
     * added first.
     *
     * @param x world x, m
     * @param y world y, m, up
     * @param within greatest distance looked at, m, 0 or more
     * @param filter which bodies are looked at
     * @throws IllegalArgumentException when a number is not finite
     */
    public Optional<NearestPoint> nearest(double x, double y, double within, Filter filter) {
        return casts().nearest(x, y, within, filter);
    }

    /**
     * Gives every dynamic body in reach of an explosion its impulse and wakes it.
     *
     * @throws IllegalArgumentException when a body would become faster than light; then no body is
     *     changed
     * @throws IllegalStateException when called within a step or from a visitor
     */
    public void explode(Explosion explosion) {
        Require.present("Pool.explode explosion", explosion);
        busy.requireChangeable("explode");
        new Blast(data.bodies, queries(), editor).of(explosion);
    }

    /**
     * Calls a visitor with every body whose shape overlaps a box (m, world frame), in a fixed
     * order.
     */
    public void overlapping(Aabb box, Consumer<RigidBody> visitor) {
        Require.present("Pool.overlapping box", box);
        Require.present("Pool.overlapping visitor", visitor);
        queries().overlapping(box).forEach(visitor);
    }

    /**
     * The whole state that later steps depend on, as bytes for {@link #restore}: bodies with names
     * and order, joints, contacts with their impulses, time, effects and accuracy. Of an effect
     * that holds a caller's function only the kind is written.
     *
     * @throws IllegalStateException when called within a step
     */
    public byte[] snapshot() {
        busy.requireBetweenSteps("take a snapshot");
        return PoolSnapshot.encode(this, data);
    }

    /**
     * A 64-bit hash of every bit of the state that later steps depend on. Two pools with equal
     * effects, accuracy and hash continue alike.
     */
    public long stateHash() {
        return totals.stateHash();
    }

    /** Kinetic energy of all dynamic bodies, of motion and rotation, J. */
    public double kineticEnergy() {
        return totals.kineticEnergy();
    }

    /**
     * Potential energy of all dynamic bodies in the declared gravity, J; 0 at the world's origin.
     */
    public double potentialEnergy() {
        return totals.potentialEnergy();
    }

    /** Momentum of all dynamic bodies to the right, N·s. */
    public double momentumX() {
        return totals.momentumX();
    }

    /** Momentum of all dynamic bodies upwards, N·s. */
    public double momentumY() {
        return totals.momentumY();
    }

    /**
     * Angular momentum of all dynamic bodies about the world's origin, counter-clockwise, kg·m²/s.
     */
    public double angularMomentum() {
        return totals.angularMomentum();
    }

    private LiveState live() {
        if (live == null) {
            live = new LiveState(this, data, plan);
        }
        return live;
    }

    PoolQueries queries() {
        if (queries == null) {
            queries = new PoolQueries(live());
        }
        return queries;
    }

    private PoolCasts casts() {
        if (casts == null) {
            casts = new PoolCasts(live(), queries());
        }
        return casts;
    }

    PoolContacts contacts() {
        if (contacts == null) {
            contacts = new PoolContacts(this, data, live(), busy);
        }
        return contacts;
    }

    /** The contacts that edits ended; null if none were asked for yet. */
    EndedContacts editedContacts() {
        return contacts == null ? null : contacts.ended;
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

    /** Throws where sensors are not declared: an empty answer would hide that none is simulated. */
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

    /** The editor of a body, once the body is alive and ours and the pool may be changed. */
    BodyEditor editor(RigidBody body) {
        own(body);
        busy.requireChangeable("change a body");
        return editor;
    }

    /** The editor without those checks: for reading only. */
    BodyEditor editor() {
        return editor;
    }

    Bodies columns() {
        return data.bodies;
    }

    RigidBody handle(int slot) {
        return bodies.atSlot(slot);
    }

    /** The editor of a joint, once the joint is alive and ours and the pool may be changed. */
    Joinery joinery(Joint joint) {
        Require.present("joint", joint).requireAlive();
        busy.requireChangeable("change a joint");
        if (joints == null || joint.pool() != this) {
            throw new IllegalArgumentException(joint + " belongs to another pool");
        }
        return joints.joinery();
    }

    /** The editor of joints without those checks: for reading only. */
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
