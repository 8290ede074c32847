package rigibo.backend.storage;

import java.util.Arrays;
import java.util.function.Consumer;

/**
 * The room in the columns of a table. It doubles, but not all at once: from three quarters on,
 * column after column is copied into one twice as long, in step with the slots that are handed out,
 * so that the last column is done with the last slot. To copy them all costs a step megabytes at
 * once where there are ten thousand pairs.
 */
final class Room implements ColumnVisitor {

    /** Slots up to which all columns are copied at once: together they are a few hundred kB. */
    private static final int FEW = 1024;

    private final Consumer<ColumnVisitor> table;

    /** Slots that every column has room for. */
    private int slots;

    /** The slot that the first column is copied for, and the one that the next is copied for. */
    private int first;

    private int next;

    /** Of a pass through the table: bits a slot of the columns so far, and up to how many to go. */
    private long passed;

    private long due;

    /** The room in new columns of so many slots, which a table is going to show. */
    Room(int slots, Consumer<ColumnVisitor> table) {
        this.table = table;
        begin(slots);
    }

    private void begin(int room) {
        slots = room;
        first = room > FEW ? room / 4 * 3 : room;
        next = first;
    }

    /** How many slots every column has room for. */
    int slots() {
        return slots;
    }

    /** How many slots some columns have room for already: as many, or twice as many. */
    int slotsAhead() {
        return next > first ? 2 * slots : slots;
    }

    /** Makes room for a slot, which is the lowest that was never handed out. */
    void hold(int slot) {
        if (slot >= next) {
            grow(slot);
        }
    }

    /** Makes room for so many slots, all of which can be handed out before any column is copied. */
    void reserve(int count) {
        while (slots < count) {
            lengthen(Long.MAX_VALUE);
            begin(2 * slots);
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
        long copied = lengthen(wanted);
        if (copied == all) {
            begin(2 * slots);
        } else {
            next = first + (int) (copied * steps / all);
        }
    }

    /** Copies columns up to so many bits a slot; answers how many those up to there have. */
    private long lengthen(long bits) {
        passed = 0;
        due = bits;
        table.accept(this);
        return passed;
    }

    /** The length that a column of so many bits has to have now. */
    private int length(int present, int perSlot, int bits) {
        if (passed >= due) {
            return present;
        }
        passed += bits;
        // A column may be twice as long already: PairOrder sorts into others than it sorts from.
        return Math.max(present, 2 * slots * perSlot);
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
