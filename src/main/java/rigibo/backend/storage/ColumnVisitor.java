package rigibo.backend.storage;

/**
 * An operation on all columns of a table. It receives the columns one by one and returns, for each,
 * the array that the field holds from then on: the same one, a longer one, or null. A column that
 * no declared effect needs is null. Since the table names every column, no operation can forget
 * one.
 */
public interface ColumnVisitor {

    /** A column of references, which exists whatever effects are declared. */
    <T> T[] column(String name, Role role, T[] column);

    /** A column with one number per slot. */
    double[] column(String name, Role role, Need need, double[] column);

    /**
     * A column that has the values of another one ({@code idle}) while the effects that need it are
     * not declared; other columns are 0 then.
     */
    default double[] column(String name, Role role, Need need, double[] column, double[] idle) {
        return column(name, role, need, column);
    }

    /** A column with one whole number per slot. */
    int[] column(String name, Role role, Need need, int[] column);

    /** A column with one boolean per slot. */
    boolean[] column(String name, Role role, Need need, boolean[] column);

    /** A column with two numbers per slot, at 2·slot and 2·slot + 1. */
    double[] twins(String name, Role role, Need need, double[] column);

    /** A column with two whole numbers per slot, at 2·slot and 2·slot + 1. */
    int[] twins(String name, Role role, Need need, int[] column);
}
