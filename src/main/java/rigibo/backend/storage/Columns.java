package rigibo.backend.storage;

import java.util.Arrays;

/** Columns that are there only while what needs them is declared, and null otherwise. */
final class Columns {

    private Columns() {}

    /** The column, made with room for so many if it is newly declared, or null if it is not. */
    static double[] declared(double[] column, boolean isDeclared, int capacity) {
        if (!isDeclared) {
            return null;
        }
        return column != null ? column : new double[capacity];
    }

    static int[] declared(int[] column, boolean isDeclared, int capacity) {
        if (!isDeclared) {
            return null;
        }
        return column != null ? column : new int[capacity];
    }

    static boolean[] declared(boolean[] column, boolean isDeclared, int capacity) {
        if (!isDeclared) {
            return null;
        }
        return column != null ? column : new boolean[capacity];
    }

    /** The column with room for so many, if there is one. */
    static double[] grown(double[] column, int capacity) {
        return column == null ? null : Arrays.copyOf(column, capacity);
    }

    static int[] grown(int[] column, int capacity) {
        return column == null ? null : Arrays.copyOf(column, capacity);
    }

    static boolean[] grown(boolean[] column, int capacity) {
        return column == null ? null : Arrays.copyOf(column, capacity);
    }

    /**
     * Bits of all columns for each of their elements; a reference counts, not what it refers to.
     */
    static int bits(Object... columns) {
        return Arrays.stream(columns).mapToInt(Columns::bitsOf).sum();
    }

    private static int bitsOf(Object column) {
        if (column == null) {
            return 0;
        }
        return column instanceof double[]
                ? Double.SIZE
                : column instanceof boolean[] ? Byte.SIZE : Integer.SIZE;
    }
}
