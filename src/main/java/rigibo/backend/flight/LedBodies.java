package rigibo.backend.flight;

import rigibo.backend.storage.Bodies;
import rigibo.backend.storage.Growth;

import java.util.Arrays;

/**
 * The bodies of the contacts that ways are handed on through, packed. Those that are led off have
 * eight doubles each, one cache line, for two ways; the second way of a body is opposed to the
 * first. All others share the first line, of zeros.
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

    /** The ways, two by two; see {@link #firstWay}. */
    double[] ways = new double[2 * STRIDE * 16];

    /** Number of lines of ways. */
    private int lines;

    /** By entry: its mass, kg; infinite for what is fixed or driven. */
    double[] mass = new double[16];

    /** By entry: whether it can be led off. */
    boolean[] moves = new boolean[16];

    /** By entry: the place of its first way, 0 if it is not led off. */
    private int[] firstWay = new int[16];

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
        lines = 1;
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
            grow(Growth.after(entry));
        }
        boolean isDynamic = bodies.isDynamic(slot);
        slots[entry] = slot;
        entries[slot] = entry;
        mass[entry] = isDynamic ? 1 / bodies.inverseMass[slot] : Double.POSITIVE_INFINITY;
        moves[entry] = isDynamic;
        firstWay[entry] = 0;
        lastSide[entry] = NONE;
        return entry;
    }

    private void grow(int capacity) {
        slots = Arrays.copyOf(slots, capacity);
        mass = Arrays.copyOf(mass, capacity);
        moves = Arrays.copyOf(moves, capacity);
        firstWay = Arrays.copyOf(firstWay, capacity);
        lastSide = Arrays.copyOf(lastSide, capacity);
    }

    /** The slot of an entry. */
    int slot(int entry) {
        return slots[entry];
    }

    /** The place of an entry's first way; the second one follows. */
    int firstWay(int entry) {
        return firstWay[entry];
    }

    /** Whether an entry is led off. */
    boolean isLed(int entry) {
        return firstWay[entry] > 0;
    }

    /** Gives an entry that is not led off two ways of no length. */
    void lead(int entry) {
        int way = 2 * STRIDE * lines++;
        if (way == ways.length) {
            ways = Arrays.copyOf(ways, Growth.after(way));
        }
        Arrays.fill(ways, way, way + 2 * STRIDE, 0);
        firstWay[entry] = way;
    }

    /** Whether a push along a direction may lengthen the second way of an entry, not the first. */
    boolean isSecondAlong(int entry, double nx, double ny) {
        return along(firstWay[entry], nx, ny) < 0;
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
