package rigibo.backend.storage;

import java.util.function.Consumer;

/** Sums the bits per slot of all columns that exist. */
final class SlotSize implements ColumnVisitor {

    private int bits;

    private SlotSize() {}

    /**
     * Bits per slot of all columns of a table; a reference counts, the object behind it does not.
     */
    static int of(Consumer<ColumnVisitor> table) {
        SlotSize size = new SlotSize();
        table.accept(size);
        return size.bits;
    }

    @Override
    public <T> T[] column(String name, Role role, T[] column) {
        bits += Integer.SIZE;
        return column;
    }

    @Override
    public double[] column(String name, Role role, Need need, double[] column) {
        bits += column == null ? 0 : Double.SIZE;
        return column;
    }

    @Override
    public int[] column(String name, Role role, Need need, int[] column) {
        bits += column == null ? 0 : Integer.SIZE;
        return column;
    }

    @Override
    public boolean[] column(String name, Role role, Need need, boolean[] column) {
        bits += column == null ? 0 : Byte.SIZE;
        return column;
    }

    @Override
    public double[] twins(String name, Role role, Need need, double[] column) {
        bits += column == null ? 0 : 2 * Double.SIZE;
        return column;
    }

    @Override
    public int[] twins(String name, Role role, Need need, int[] column) {
        bits += column == null ? 0 : 2 * Integer.SIZE;
        return column;
    }
}
