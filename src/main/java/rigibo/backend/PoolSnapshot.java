package rigibo.backend;

import rigibo.backend.effect.Effects;
import rigibo.backend.saved.SavedContact;
import rigibo.backend.saved.Snapshot;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.DataStorage;

import java.util.function.IntConsumer;
import java.util.function.Supplier;

/**
 * Snapshots of other revisions of the simulation: {@link Pool#restore(byte[])} refuses them, for a
 * pool restored from one goes on from the same state, but to other bits than it once did.
 *
 * <pre>{@code
 * byte[] kept = pool.snapshot();
 * int revision = PoolSnapshot.revision(kept);
 * }</pre>
 */
public final class PoolSnapshot {

    private static final String RESTORE = "Pool.restore";
    private static final String OF_ANY = "PoolSnapshot.restoreOfAnyRevision";

    private static final IntConsumer PRESENT = PoolSnapshot::requirePresent;
    private static final IntConsumer ANY = revision -> {};

    private PoolSnapshot() {}

    /**
     * The {@link Pool#REVISION} of the engine that wrote a snapshot.
     *
     * @throws IllegalArgumentException when it is cut short, altered or of another format
     */
    public static int revision(byte[] snapshot) {
        Require.present("PoolSnapshot.revision snapshot", snapshot);
        return told("PoolSnapshot.revision", () -> Snapshot.revision(snapshot));
    }

    /**
     * A pool with the state of a snapshot, whatever its revision.
     *
     * @throws IllegalArgumentException as {@link Pool#restore(byte[])}, but for the revision
     */
    public static Pool restoreOfAnyRevision(byte[] snapshot) {
        Require.present(OF_ANY + " snapshot", snapshot);
        return told(OF_ANY, () -> new Pool(Snapshot.decode(snapshot, ANY)));
    }

    /**
     * Restores a snapshot of any revision, with the caller's effects in place of those saved.
     *
     * @throws IllegalArgumentException as {@link Pool#restore(byte[], Effects)}, but for the
     *     revision
     */
    public static Pool restoreOfAnyRevision(byte[] snapshot, Effects effects) {
        Require.present(OF_ANY + " snapshot", snapshot);
        Require.present(OF_ANY + " effects", effects);
        return told(OF_ANY, () -> new Pool(Snapshot.decode(snapshot, ANY, effects)));
    }

    static Pool restore(byte[] snapshot) {
        Require.present(RESTORE + " snapshot", snapshot);
        return told(RESTORE, () -> new Pool(Snapshot.decode(snapshot, PRESENT)));
    }

    static Pool restore(byte[] snapshot, Effects effects) {
        Require.present(RESTORE + " snapshot", snapshot);
        Require.present(RESTORE + " effects", effects);
        return told(RESTORE, () -> new Pool(Snapshot.decode(snapshot, PRESENT, effects)));
    }

    private static void requirePresent(int revision) {
        if (revision != Pool.REVISION) {
            throw new IllegalArgumentException(
                    "must be of revision "
                            + Pool.REVISION
                            + " of the simulation, was "
                            + revision
                            + ": it would go on to other bits;"
                            + " PoolSnapshot.restoreOfAnyRevision goes on all the same");
        }
    }

    static byte[] encode(Pool pool, DataStorage data) {
        Snapshot snapshot = new Snapshot(pool.effects(), pool.accuracy(), data);
        snapshot.time = pool.time();
        snapshot.order = pool.bodies().stream().mapToInt(RigidBody::slot).toArray();
        snapshot.names = pool.bodies().stream().map(RigidBody::name).toArray(String[]::new);
        snapshot.ended = pool.savedContacts().toArray(new SavedContact[0]);
        snapshot.jointOrder = pool.jointOrder();
        return snapshot.encode();
    }

    /** Says whose snapshot it is that cannot be read. */
    private static <T> T told(String verb, Supplier<T> reading) {
        try {
            return reading.get();
        } catch (IllegalArgumentException refusal) {
            throw new IllegalArgumentException(
                    verb + " snapshot: " + refusal.getMessage(), refusal);
        }
    }
}
