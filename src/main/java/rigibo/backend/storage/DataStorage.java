package rigibo.backend.storage;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Joints;

/** All live state of a pool: the columns of bodies and pairs, and what a step counts. */
public final class DataStorage {

    public final Bodies bodies;
    public final Pairs pairs;
    public final Roster roster = new Roster();
    public final Islands islands = new Islands();
    public final StillContacts stillContacts;
    public final Counters counters = new Counters();

    /** Slots of the bodies that forces were asked for since the last step, some twice. */
    public final Found thrusting = new Found();

    /** Slots of the bodies on their way to a place, some twice, and some that no longer are. */
    public final Found steered = new Found();

    /** Who is near a sensor, and where bodies were struck; null where no shape is a sensor. */
    public Visits visits;

    public Ways ways;

    /** The impacts of the last step; null where nothing ever resolved any. */
    public Hits hits;

    /** The joints, or null where none are declared. */
    public JointStore joints;

    /** Stands for the joints where none are declared and bodies are held by an axis. */
    private JointStore noJoints;

    /** When the step in progress began, s since the pool was made. */
    public double time;

    /** Storage with the columns that a set of effects needs. */
    public DataStorage(Effects effects) {
        bodies = new Bodies(effects);
        pairs = new Pairs(effects);
        stillContacts = new StillContacts(bodies, pairs);
        declareJoints(effects);
    }

    /** Makes the store of joints where they are declared, and drops it where they are not. */
    public void declareJoints(Effects effects) {
        if (!effects.declares(Joints.class)) {
            joints = null;
        } else if (joints == null) {
            joints = new JointStore();
        }
    }

    /**
     * Whether there may be islands that are solved with equations beside their contacts: joints are
     * declared, or a body is kept from moving along an axis.
     */
    public boolean hasAssemblies() {
        return joints != null || bodies.lockedX != null;
    }

    /** The joints, or none where they are not declared. */
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

    /** Makes columns that a body needs, whatever is declared. */
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

    /** Where whoever resolves impacts notes them. */
    public Hits noteHits() {
        if (hits == null) {
            hits = new Hits();
        }
        return hits;
    }

    /** Begins a step, of which nothing is told yet. */
    public void beginStep() {
        counters.clear();
        if (hits != null) {
            hits.clear(pairs.room());
        }
    }

    /** Makes room for so many bodies and pairs. */
    public void reserve(int bodyCount, int pairCount) {
        bodies.reserve(bodyCount);
        pairs.reserve(pairCount);
        pairs.index.reserve(pairCount);
    }
}
