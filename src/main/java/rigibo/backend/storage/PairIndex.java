package rigibo.backend.storage;

/**
 * Finds the pair of two shapes: a hash table with open addressing and linear probing. It is never
 * iterated, so its layout cannot influence the simulation.
 */
public final class PairIndex {

    /** Returned when two shapes are no pair. */
    public static final int ABSENT = -1;

    private static final long EMPTY = -1;
    private static final int FIRST_CAPACITY = 256;

    private long[] keys = filled(FIRST_CAPACITY);
    private int[] pairs = new int[FIRST_CAPACITY];
    private int size;

    /** The pair of shapes {@code a < b}, or {@link #ABSENT}. */
    public int find(int a, int b) {
        long key = key(a, b);
        int at = home(key);
        while (keys[at] != EMPTY) {
            if (keys[at] == key) {
                return pairs[at];
            }
            at = at + 1 & keys.length - 1;
        }
        return ABSENT;
    }

    /** Makes room for a number of pairs. */
    void reserve(int count) {
        while (2 * count > keys.length) {
            grow();
        }
    }

    /** Adds the pair of shapes {@code a < b}, which must not be in the table. */
    public void put(int a, int b, int pair) {
        if (2 * ++size > keys.length) {
            grow();
        }
        place(key(a, b), pair);
    }

    /** Removes an entry and moves later entries of its run up, so that no tombstones accumulate. */
    void remove(int a, int b) {
        int mask = keys.length - 1;
        int hole = home(key(a, b));
        while (keys[hole] != key(a, b)) {
            hole = hole + 1 & mask;
        }
        int at = hole;
        while (true) {
            at = at + 1 & mask;
            if (keys[at] == EMPTY) {
                break;
            }
            int distanceToHole = at - hole & mask;
            int distanceToHome = at - home(keys[at]) & mask;
            if (distanceToHome >= distanceToHole) {
                keys[hole] = keys[at];
                pairs[hole] = pairs[at];
                hole = at;
            }
        }
        keys[hole] = EMPTY;
        size--;
    }

    /** Renumbers the pairs: {@code numbers} holds the new number of each old one. */
    void renumber(int[] numbers) {
        for (int at = 0; at < keys.length; at++) {
            if (keys[at] != EMPTY) {
                pairs[at] = numbers[pairs[at]];
            }
        }
    }

    private void place(long key, int pair) {
        int at = home(key);
        while (keys[at] != EMPTY) {
            at = at + 1 & keys.length - 1;
        }
        keys[at] = key;
        pairs[at] = pair;
    }

    private void grow() {
        long[] oldKeys = keys;
        int[] oldPairs = pairs;
        keys = filled(2 * oldKeys.length);
        pairs = new int[keys.length];
        for (int i = 0; i < oldKeys.length; i++) {
            if (oldKeys[i] != EMPTY) {
                place(oldKeys[i], oldPairs[i]);
            }
        }
    }

    private int home(long key) {
        // Fibonacci hashing: multiples of the golden ratio spread neighbouring keys evenly.
        return (int) (key * 0x9E3779B97F4A7C15L >>> 40) & keys.length - 1;
    }

    private static long key(int a, int b) {
        return (long) a << 32 | b;
    }

    private static long[] filled(int capacity) {
        long[] keys = new long[capacity];
        java.util.Arrays.fill(keys, EMPTY);
        return keys;
    }
}
