package rigibo.backend.storage;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;

/**
 * All live state of a pool: the columns of bodies, pairs and joints, and the counters of a step.
 */
public final class DataStorage {

    public final Bodies bodies;
    public final Pairs pairs;
    public final Roster roster;
    public final Islands islands;
    public final StillContacts stillContacts;
    public final Counters counters = new Counters();

    /** Slots of the bodies to which forces were applied since the last step; some appear twice. */
    public final Found thrusting;

    /**
     * Slots of the bodies that are driven to a target pose; some appear twice, and some have
     * arrived.
     */
    public final Found steered;

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

    /** Joints that broke in this step, in the order in which they did. */
    public final Found broken = new Found();

    /** An empty store, for islands with locked axes where no joints are declared. */
    private JointStore noJoints;

    /** Start of the step in progress, s since the pool was made. */
    public double time;

    /** Storage with the columns that a set of effects needs. */
    public DataStorage(Effects effects) {
        bodies = new Bodies(effects);
        pairs = new Pairs(effects);
        roster = new Roster();
        islands = new Islands();
        thrusting = new Found();
        steered = new Found();
        stillContacts = new StillContacts(bodies, pairs);
        declareJoints(effects);
    }

    private DataStorage(DataStorage shared) {
        bodies = shared.bodies;
        pairs = shared.pairs;
        roster = shared.roster;
        islands = shared.islands;
        thrusting = shared.thrusting;
        steered = shared.steered;
        stillContacts = shared.stillContacts;
        joints = shared.joints;
        noJoints = shared.noJoints;
        hits = shared.hits == null ? null : new Hits();
    }

    /**
     * A view of the same state for another worker, valid until effects change. Three lists to which
     * several islands append are its own: impacts, broken joints and bodies put to rest.
     */
    public DataStorage forWorker() {
        return new DataStorage(this);
    }

    /** Begins work on islands that are shared: lists are empty. */
    public void beginShared(DataStorage shared) {
        counters.clear();
        broken.clear();
        if (hits != null) {
            hits.beginShared(shared.hits);
        }
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
