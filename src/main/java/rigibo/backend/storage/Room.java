package rigibo.backend.storage;

import java.util.Arrays;
import java.util.function.Consumer;

/**
 * The capacity of the columns of a table. It grows by half, where it is large by a quarter, but not
 * in one step: while the last quarter of the slots is assigned, or the last sixteenth, one column
 * after another is copied into a longer array, in proportion to the slots assigned, so that the
 * last one is copied with the last slot. Copying all of them at once would cost a single step
 * megabytes with ten thousand pairs.
 *
 * <p>The columns at the end of the table are copied first. Scratch is made as long as the columns
 * at its beginning, and so grows no sooner than it must.
 */
final class Room implements ColumnVisitor {

    /**
     * Capacity up to which all columns are copied at once, into arrays twice as long; together they
     * take a few hundred kB.
     */
    private static final int FEW = 1024;

    /** Share of the slots, as its divisor, during whose assignment the columns are copied. */
    private static final int EARLY = 4;

    /** That divisor for {@link Growth#LARGE} tables, whose columns would be too long for longer. */
    private static final int LATE = 16;

    private final Consumer<ColumnVisitor> table;

    /** Number of slots for which every column has room. */
    private int slots;

    /** Slot at which the first column is copied, and slot at which the next one is. */
    private int first;

    private int next;

    /**
     * While the table is visited: bits per slot of the columns so far, of those at its beginning
     * that stay as they are, and of those that are as long as they should be.
     */
    private long passed;

    private long staying;
    private long lengthened;

    /** The capacity of a table whose columns have room for a number of slots. */
    Room(int slots, Consumer<ColumnVisitor> table) {
        this.table = table;
        begin(slots);
    }

    private void begin(int room) {
        slots = room;
        int last = room > Growth.LARGE ? room / LATE : room / EARLY;
        first = room > FEW ? room - last : room;
        next = first;
    }

    /** Number of slots for which every column has room. */
    int slots() {
        return slots;
    }

    /** Number of slots for which the last columns have room: the same, or more. */
    int slotsAhead() {
        return next > first ? more() : slots;
    }

    private int more() {
        int grown = slots < FEW ? 2 * slots : slots + slots / 2;
        return slots < Growth.LARGE ? grown : Growth.after(slots);
    }

    /** Makes room for a slot, which must be the lowest that was never assigned. */
    void hold(int slot) {
        if (slot >= next) {
            grow(slot);
        }
    }

    /**
     * Makes room for a number of slots, all of which can be assigned before a column is copied
     * again.
     */
    void reserve(int count) {
        while (slots < count) {
            lengthen(0);
            begin(more());
        }
        if (count > first) {
            first = count;
            next = Math.max(next, first);
        }
    }

    private void grow(int slot) {
        long all = SlotSize.of(table);
        long steps = slots - first;
        // Rounded up, so that the column is copied before its last slot is needed.
        long wanted = slot < slots ? (all * (slot + 1 - first) + steps - 1) / steps : all;
        long copied = lengthen(all - wanted);
        if (copied == all) {
            begin(more());
        } else {
            next = first + (int) (copied * steps / all);
        }
    }

    /**
     * Copies all columns but those at the beginning of the table that amount to so many bits per
     * slot; returns the bits per slot of the others.
     */
    private long lengthen(long bits) {
        passed = 0;
        lengthened = 0;
        staying = bits;
        table.accept(this);
        return lengthened;
    }

    /** The length that a column should have now. */
    private int length(int present, int perSlot, int bits) {
        passed += bits;
        if (passed <= staying) {
            return present;
        }
        lengthened += bits;
        return Math.max(present, more() * perSlot);
    }

    @Override
    public <T> T[] column(String name, Role role, T[] column) {
        int length = length(column.length, 1, Integer.SIZE);
        return length == column.length ? column : Arrays.copyOf(column, length);
    }

    @Override
    public double[] column(String name, Role role, Need need, double[] column) {
        return column == null ? null : longer(column, 1);
    }

    @Override
    public double[] twins(String name, Role role, Need need, double[] column) {
        return column == null ? null : longer(column, 2);
    }

    private double[] longer(double[] column, int perSlot) {
        int length = length(column.length, perSlot, perSlot * Double.SIZE);
        return length == column.length ? column : Arrays.copyOf(column, length);
    }

    @Override
    public int[] column(String name, Role role, Need need, int[] column) {
        return column == null ? null : longer(column, 1);
    }

    @Override
    public int[] twins(String name, Role role, Need need, int[] column) {
        return column == null ? null : longer(column, 2);
    }

    private int[] longer(int[] column, int perSlot) {
        int length = length(column.length, perSlot, perSlot * Integer.SIZE);
        return length == column.length ? column : Arrays.copyOf(column, length);
    }

    @Override
    public boolean[] column(String name, Role role, Need need, boolean[] column) {
        if (column == null) {
            return null;
        }
        int length = length(column.length, 1, Byte.SIZE);
        return length == column.length ? column : Arrays.copyOf(column, length);
    }
}
