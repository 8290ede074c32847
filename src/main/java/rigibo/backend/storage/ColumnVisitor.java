package rigibo.backend.storage;

/**
 * Is shown the columns of a table one by one, and answers for each the array that its field is to
 * hold from now on: the one shown, a longer one, or none. A column that nothing declared needs is
 * null. Whatever is done to all columns is such a visitor, so that none of them can be forgotten.
 */
public interface ColumnVisitor {

    /** A column of references, which every set of effects needs. */
    <T> T[] column(String name, Role role, T[] column);

    /** A column of one number for each slot. */
    double[] column(String name, Role role, Need need, double[] column);

    /**
     * A column that holds what another does, where the effects that need it do nothing; of others
     * it is 0 then.
     */
    default double[] column(String name, Role role, Need need, double[] column, double[] idle) {
        return column(name, role, need, column);
    }

    /** A column of one whole number for each slot. */
    int[] column(String name, Role role, Need need, int[] column);

    /** A column of one statement for each slot. */
    boolean[] column(String name, Role role, Need need, boolean[] column);

    /** A column of two numbers for each slot, at twice the slot and after it. */
    double[] twins(String name, Role role, Need need, double[] column);

    /** A column of two whole numbers for each slot, likewise. */
    int[] twins(String name, Role role, Need need, int[] column);
}
