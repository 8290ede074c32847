package rigibo.backend;

import rigibo.backend.storage.DataStorage;

import java.lang.reflect.Field;

/** The columns of a pool, which it shows nobody. */
public final class PoolStorage {

    private PoolStorage() {}

    /** Gives tests access to a pool's storage. */
    public static DataStorage of(Pool pool) {
        try {
            Field data = Pool.class.getDeclaredField("data");
            data.setAccessible(true);
            return (DataStorage) data.get(pool);
        } catch (ReflectiveOperationException moved) {
            throw new AssertionError("where a pool keeps its columns", moved);
        }
    }
}
