package rigibo.backend.storage;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;

/**
 * All live state of a pool: the columns of bodies, pairs and joints, and the counters of a step.
 */
public final class DataStorage {

    public final Bodies bodies;
    public final Pairs pairs;
    public final Roster roster = new Roster();
    public final Islands islands = new Islands();
    public final StillContacts stillContacts;
    public final Counters counters = new Counters();

    /** Slots of the bodies to which forces were applied since the last step; some appear twice. */
    public final Found thrusting = new Found();

    /**
     * Slots of the bodies that are driven to a target pose; some appear twice, and some have
     * arrived.
     */
    public final Found steered = new Found();

    /**
     * Shapes near sensors, and the paths of struck bodies; both are null while no shape is a
     * sensor.
     */
    public Visits visits;

    public Ways ways;

    /** The impacts of the last step; null until a stage resolves impacts. */
    public Hits hits;

    /** The joints; null where none are declared. */
    public JointStore joints;

    /** An empty store, for islands with locked axes where no joints are declared. */
    private JointStore noJoints;

    /** Start of the step in progress, s since the pool was made. */
    public double time;

    /** Storage with the columns that a set of effects needs. */
    public DataStorage(Effects effects) {
        bodies = new Bodies(effects);
        pairs = new Pairs(effects);
        stillContacts = new StillContacts(bodies, pairs);
        declareJoints(effects);
    }

    /** Makes the store of joints if they are declared, and drops it if not. */
    public void declareJoints(Effects effects) {
        if (!effects.declares(Joints.class)) {
            joints = null;
        } else if (joints == null) {
            joints = new JointStore();
        }
    }

    /**
     * Whether an island may have equations besides its contacts: joints are declared, or a body's
     * motion along an axis is locked.
     */
    public boolean hasAssemblies() {
        return joints != null || bodies.lockedX != null;
    }

    /** The joints; an empty store where none are declared. */
    public JointStore jointsOrNone() {
        if (joints != null) {
            return joints;
        }
        if (noJoints == null) {
            noJoints = new JointStore();
        }
        return noJoints;
    }

    /** Whether a body is held by a joint. */
    public boolean isJoined(int body) {
        return joints != null && joints.holds(bodies, body);
    }

    /** Makes columns that a body needs, whatever effects are declared. */
    public void hold(Need need) {
        bodies.hold(need);
        if (need == Need.COMPOUNDS) {
            pairs.holdCompounds();
        } else if (need == Need.ONE_SIDED) {
            pairs.holdOneSided();
        } else if (need == Need.SENSORS && visits == null) {
            visits = new Visits();
            ways = new Ways();
        }
    }

    /** Returns the list of impacts, for a stage that resolves them; makes it at first use. */
    public Hits noteHits() {
        if (hits == null) {
            hits = new Hits();
        }
        return hits;
    }

    /** Begins a step: clears counters and impacts. */
    public void beginStep() {
        counters.clear();
        if (hits != null) {
            hits.clear(pairs.room());
        }
    }

    /** Makes room for a number of bodies and pairs. */
    public void reserve(int bodyCount, int pairCount) {
        bodies.reserve(bodyCount);
        pairs.reserve(pairCount);
        pairs.index.reserve(pairCount);
    }
}
