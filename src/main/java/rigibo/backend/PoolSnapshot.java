package rigibo.backend;

import rigibo.backend.effect.Effects;
import rigibo.backend.saved.SavedContact;
import rigibo.backend.saved.Snapshot;
import rigibo.backend.setup.Require;
import rigibo.backend.storage.DataStorage;

import java.util.function.IntConsumer;
import java.util.function.Supplier;

/**
 * Restores snapshots that another revision of the simulation wrote. {@link Pool#restore(byte[])}
 * refuses them: a pool restored from one has the same state, but continues to different bits than
 * the original did.
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
     * @throws IllegalArgumentException when the snapshot is truncated, altered or of another format
     */
    public static int revision(byte[] snapshot) {
        Require.present("PoolSnapshot.revision snapshot", snapshot);
        return told("PoolSnapshot.revision", () -> Snapshot.revision(snapshot));
    }

    /**
     * Restores a pool from a snapshot of any revision.
     *
     * @throws IllegalArgumentException as {@link Pool#restore(byte[])} does, except for the
     *     revision
     */
    public static Pool restoreOfAnyRevision(byte[] snapshot) {
        Require.present(OF_ANY + " snapshot", snapshot);
        return told(OF_ANY, () -> new Pool(Snapshot.decode(snapshot, ANY)));
    }

    /**
     * Restores a pool from a snapshot of any revision, with the given effects in place of the saved
     * ones.
     *
     * @throws IllegalArgumentException as {@link Pool#restore(byte[], Effects)} does, except for
     *     the revision
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

    /** Prefixes the message of a refused snapshot with the method that was called. */
    private static <T> T told(String verb, Supplier<T> reading) {
        try {
            return reading.get();
        } catch (IllegalArgumentException refusal) {
            throw new IllegalArgumentException(
                    verb + " snapshot: " + refusal.getMessage(), refusal);
        }
    }
}
