package rigibo.backend;

import rigibo.backend.saved.SavedContact;
import rigibo.backend.saved.Snapshot;
import rigibo.backend.storage.DataStorage;

import java.util.function.Supplier;

/** Writes a pool as bytes, and says whose fault it is when they cannot be read. */
final class PoolSnapshot {

    private PoolSnapshot() {}

    static byte[] encode(Pool pool, DataStorage data) {
        Snapshot snapshot = new Snapshot(pool.effects(), pool.accuracy(), data);
        snapshot.time = pool.time();
        snapshot.order = pool.bodies().stream().mapToInt(RigidBody::slot).toArray();
        snapshot.names = pool.bodies().stream().map(RigidBody::name).toArray(String[]::new);
        snapshot.ended = pool.savedContacts().toArray(new SavedContact[0]);
        return snapshot.encode();
    }

    static Pool restored(Supplier<Pool> restoring) {
        try {
            return restoring.get();
        } catch (IllegalArgumentException refusal) {
            throw new IllegalArgumentException(
                    "Pool.restore snapshot: " + refusal.getMessage(), refusal);
        }
    }
}
