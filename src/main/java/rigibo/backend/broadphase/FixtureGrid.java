package rigibo.backend.broadphase;

import rigibo.backend.storage.Found;

import java.util.Arrays;

/**
 * Fixtures by the square cell of their lower left corner, in a hash table of cells. A fixture
 * changes cells, and a query finds neighbours, without walking through a tree.
 *
 * <p>Each power of two has a grid of its own (hierarchical hash grids: C. Ericson, Real-Time
 * Collision Detection, 2005, section 7.2). A fixture is in the grid whose cells are at least as
 * large as it is, and less than twice as large. So a query examines a few cells of each grid,
 * however unlike the sizes of bodies are.
 *
 * <p>Round-off misses no fixture, however far out. The corner of a fixture that reaches a box is
 * not below the rounded difference of the box's corner and the greatest width, and the number of a
 * cell never falls as places grow.
 */
final class FixtureGrid {

    private static final int NONE = -1;

    /** Cells of level 0 are 2⁻³² m wide, those of the last one 2³¹ m. */
    private static final int LEVELS = 64;

    private static final int METRE = 32;

    /**
     * Farthest cell from the origin that may hold a fixture: doubles still tell it from the next
     * one.
     */
    private static final double FARTHEST = 1L << 50;

    /** Number of cells up to which a query never examines all fixtures instead. */
    private static final double FEW_CELLS = 64;

    /** Multiples of the golden ratio spread the rows of cells over the table. */
    private static final long SPREAD = 0x9E3779B97F4A7C15L;

    private static final int FIRST_CAPACITY = 64;

    /** Cells per metre, by level. */
    private static final double[] CELLS_PER_METRE = new double[LEVELS];

    /** First row of each level in the table; those of two levels must not coincide. */
    private static final long[] FIRST_ROW = new long[LEVELS];

    static {
        double cells = 1L << METRE;
        for (int level = 0; level < LEVELS; level++) {
            CELLS_PER_METRE[level] = cells;
            FIRST_ROW[level] = scatter(level);
            cells /= 2;
        }
    }

    /** First fixture of each entry of the table; and the shift that makes a hash an index of it. */
    private int[] first = filled(FIRST_CAPACITY);

    private int shift = Long.SIZE - Integer.numberOfTrailingZeros(FIRST_CAPACITY);

    /** By fixture: the next one of its entry, that entry, and its level or {@link #NONE}. */
    private int[] next = new int[FIRST_CAPACITY];

    private int[] entry = new int[FIRST_CAPACITY];
    private byte[] level = unused(FIRST_CAPACITY);

    /** Boxes, four doubles each: min x, min y, max x, max y. */
    private double[] box = new double[4 * FIRST_CAPACITY];

    /** Number of fixtures in each level, a bit for each level that has some, and the total. */
    private final int[] population = new int[LEVELS];

    private long populated;

    /** Greatest width and height of a box in each level since it was last empty, rounded up, m. */
    private final double[] widest = new double[LEVELS];

    private final double[] highest = new double[LEVELS];

    private int count;

    private long looked;

    /**
     * Puts the box of a fixture (m) into its cell, or moves it there from another one; returns
     * false and changes nothing if the cell is too far out.
     */
    boolean put(int number, double minX, double minY, double maxX, double maxY) {
        int wanted = Math.getExponent(Math.max(maxX - minX, maxY - minY)) + 1 + METRE;
        if (wanted < 0 || wanted >= LEVELS) {
            return false;
        }
        double column = Math.floor(minX * CELLS_PER_METRE[wanted]);
        double row = Math.floor(minY * CELLS_PER_METRE[wanted]);
        if (!(Math.abs(column) < FARTHEST && Math.abs(row) < FARTHEST)) {
            return false;
        }
        hold(number);
        place(number, wanted, entryOf((long) column, (long) row, wanted));
        widest[wanted] = Math.max(widest[wanted], Math.nextUp(maxX - minX));
        highest[wanted] = Math.max(highest[wanted], Math.nextUp(maxY - minY));
        int at = 4 * number;
        box[at] = minX;
        box[at + 1] = minY;
        box[at + 2] = maxX;
        box[at + 3] = maxY;
        return true;
    }

    private void place(int number, int wanted, int to) {
        if (level[number] != wanted) {
            if (level[number] != NONE) {
                remove(number);
            }
            enter(number, wanted);
            link(number, to);
        } else if (entry[number] != to) {
            unlink(number);
            link(number, to);
        }
    }

    private void enter(int number, int wanted) {
        if (population[wanted]++ == 0) {
            populated |= 1L << wanted;
            widest[wanted] = 0;
            highest[wanted] = 0;
        }
        level[number] = (byte) wanted;
        count++;
    }

    void remove(int number) {
        unlink(number);
        int former = level[number];
        if (--population[former] == 0) {
            populated &= ~(1L << former);
        }
        level[number] = NONE;
        count--;
    }

    /** Number of fixtures held. */
    int count() {
        return count;
    }

    /** Number of boxes compared with the box of a query since the grid was made. */
    long looked() {
        return looked;
    }

    /** Appends all fixtures held, ascending. */
    void list(Found into) {
        for (int number = 0; number < level.length; number++) {
            if (level[number] != NONE) {
                into.add(number);
            }
        }
    }

    /** Min x, min y, max x and max y of all fixtures held, m; read only. */
    double[] boxes() {
        return box;
    }

    /** Appends the fixtures that share a point with a box, m; some may be appended twice. */
    void query(double minX, double minY, double maxX, double maxY, Found into) {
        for (long rest = populated; rest != 0; rest &= rest - 1) {
            int each = Long.numberOfTrailingZeros(rest);
            double scale = CELLS_PER_METRE[each];
            // A box that reaches this one begins at most the greatest width before it.
            double left = Math.floor((minX - widest[each]) * scale);
            double bottom = Math.floor((minY - highest[each]) * scale);
            double columns = Math.floor(maxX * scale) - left + 1;
            double rows = Math.floor(maxY * scale) - bottom + 1;
            if (columns * rows > Math.max(FEW_CELLS, count)) {
                look(0, first.length, minX, minY, maxX, maxY, into);
                return;
            }
            for (int row = 0; row < (int) rows; row++) {
                int start = entryOf((long) left, (long) bottom + row, each);
                look(start, (int) columns, minX, minY, maxX, maxY, into);
            }
        }
    }

    /** Examines some consecutive entries. */
    private void look(
            int start,
            int entries,
            double minX,
            double minY,
            double maxX,
            double maxY,
            Found into) {
        int[] heads = first;
        int[] following = next;
        double[] boxes = box;
        int mask = heads.length - 1;
        int seen = 0;
        for (int i = start; i < start + entries; i++) {
            for (int number = heads[i & mask]; number != NONE; number = following[number]) {
                seen++;
                int at = 4 * number;
                if (Signs.none(
                        maxX - boxes[at],
                        maxY - boxes[at + 1],
                        boxes[at + 2] - minX,
                        boxes[at + 3] - minY)) {
                    into.add(number);
                }
            }
        }
        looked += seen;
    }

    /** Entry of a cell. The cells of a row are consecutive, so that they are read together. */
    private int entryOf(long column, long row, int ofLevel) {
        long start = row * SPREAD + FIRST_ROW[ofLevel] >>> shift;
        return (int) (start + column) & first.length - 1;
    }

    /** Mixes bits (variant 13 of D. Stafford, Better Bit Mixing, 2011). */
    private static long scatter(long number) {
        long bits = number * 0xBF58476D1CE4E5B9L;
        bits = (bits ^ bits >>> 27) * 0x94D049BB133111EBL;
        return bits ^ bits >>> 31;
    }

    private void link(int number, int to) {
        entry[number] = to;
        next[number] = first[to];
        first[to] = number;
    }

    private void unlink(int number) {
        int head = first[entry[number]];
        if (head == number) {
            first[entry[number]] = next[number];
            return;
        }
        int before = head;
        while (next[before] != number) {
            before = next[before];
        }
        next[before] = next[number];
    }

    /** Makes room for a fixture, with as many entries as fixtures. */
    private void hold(int number) {
        if (number >= next.length) {
            lengthen(Math.max(next.length / 2 * 3, number + 1));
        }
        if (count == first.length) {
            first = filled(2 * first.length);
            shift--;
            rehash();
        }
    }

    private void lengthen(int capacity) {
        int before = next.length;
        next = Arrays.copyOf(next, capacity);
        entry = Arrays.copyOf(entry, capacity);
        level = Arrays.copyOf(level, capacity);
        Arrays.fill(level, before, capacity, (byte) NONE);
        box = Arrays.copyOf(box, 4 * capacity);
    }

    private void rehash() {
        for (int number = 0; number < level.length; number++) {
            if (level[number] != NONE) {
                double scale = CELLS_PER_METRE[level[number]];
                long column = (long) Math.floor(box[4 * number] * scale);
                long row = (long) Math.floor(box[4 * number + 1] * scale);
                link(number, entryOf(column, row, level[number]));
            }
        }
    }

    private static int[] filled(int capacity) {
        int[] heads = new int[capacity];
        Arrays.fill(heads, NONE);
        return heads;
    }

    private static byte[] unused(int capacity) {
        byte[] levels = new byte[capacity];
        Arrays.fill(levels, (byte) NONE);
        return levels;
    }
}
