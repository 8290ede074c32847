package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;

import java.util.Arrays;

/**
 * The bodies of the contacts that ways are handed on through, packed: eight doubles each, one cache
 * line, for two ways. The second way of a body is opposed to the first.
 */
final class LedBodies {

    /** Doubles per way; the constants below are the places of the quantities. */
    static final int STRIDE = 4;

    /** How far the body may be led off, x and y, and that as a length, m. */
    static final int X = 0;

    static final int Y = 1;
    static final int LENGTH = 2;

    /** The mass that pushes, the body's own included, kg. */
    static final int MASS = 3;

    /** Marks a body without an entry, and one without a side. */
    static final int NONE = -1;

    private final Bodies bodies;

    /** Number of entries. */
    private int count;

    /** By entry, twice: its ways. */
    double[] ways = new double[2 * STRIDE * 16];

    /** By entry: its mass, kg; infinite for what is fixed or driven. */
    double[] mass = new double[16];

    /** By entry: whether it can be led off. */
    boolean[] moves = new boolean[16];

    /** By entry: whether it has a way. */
    boolean[] isLed = new boolean[16];

    /** By entry: its latest side of a contact in {@link DueContacts}. */
    int[] lastSide = new int[16];

    private int[] slots = new int[16];

    /** By slot: its entry, valid only if that entry names the slot. */
    private int[] entries = new int[16];

    LedBodies(Bodies bodies) {
        this.bodies = bodies;
    }

    /** Removes all entries. */
    void clear() {
        if (entries.length < bodies.type.length) {
            entries = new int[bodies.type.length];
        }
        count = 0;
    }

    /** The entry of a body, {@link #NONE} if it has none. */
    int find(int slot) {
        int entry = entries[slot];
        return entry < count && slots[entry] == slot ? entry : NONE;
    }

    /** The entry of a body, a new one without ways if it had none. */
    int entryOf(int slot) {
        int known = find(slot);
        return known == NONE ? add(slot) : known;
    }

    private int add(int slot) {
        int entry = count++;
        if (entry == slots.length) {
            slots = Arrays.copyOf(slots, 2 * entry);
            mass = Arrays.copyOf(mass, 2 * entry);
            moves = Arrays.copyOf(moves, 2 * entry);
            isLed = Arrays.copyOf(isLed, 2 * entry);
            lastSide = Arrays.copyOf(lastSide, 2 * entry);
            ways = Arrays.copyOf(ways, 2 * STRIDE * 2 * entry);
        }
        boolean isDynamic = bodies.isDynamic(slot);
        slots[entry] = slot;
        entries[slot] = entry;
        mass[entry] = isDynamic ? 1 / bodies.inverseMass[slot] : Double.POSITIVE_INFINITY;
        moves[entry] = isDynamic && bodies.awake[slot];
        isLed[entry] = false;
        lastSide[entry] = NONE;
        Arrays.fill(ways, 2 * STRIDE * entry, 2 * STRIDE * (entry + 1), 0);
        return entry;
    }

    /** The slot of an entry. */
    int slot(int entry) {
        return slots[entry];
    }

    /** The place of an entry's first way; the second one follows. */
    static int firstWay(int entry) {
        return 2 * STRIDE * entry;
    }

    /** The way of an entry that a push along a direction may lengthen. */
    int wayAlong(int entry, double nx, double ny) {
        int first = firstWay(entry);
        return along(first, nx, ny) < 0 ? first + STRIDE : first;
    }

    /** Length of an entry's longer way, m. */
    double reach(int entry) {
        int way = firstWay(entry);
        return Math.max(ways[way + LENGTH], ways[way + STRIDE + LENGTH]);
    }

    /** Component of a way along a direction, m. */
    double along(int way, double nx, double ny) {
        return ways[way + X] * nx + ways[way + Y] * ny;
    }
}
