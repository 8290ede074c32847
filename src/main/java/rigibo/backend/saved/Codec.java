package rigibo.backend.saved;

/**
 * Goes through the numbers of a state one by one. It is handed what there is and answers what there
 * is to be: who writes or hashes gives back the same, who reads gives what was written. So one
 * description of a state serves all of them, and none can forget what another knows.
 */
interface Codec {

    /** Names what comes next, in ASCII; who reads refuses anything else in its place. */
    void label(String name);

    /**
     * Whether to go through the column of a declared effect, of which these rows are in use. Where
     * the effect does nothing it holds what {@code idle} does, or 0 where that is null.
     */
    default boolean keeps(String name, double[] column, double[] idle, int[] rows) {
        return true;
    }

    int number(int value);

    double number(double value);

    boolean flag(boolean value);

    String text(String value);

    /** How many entries follow that are written in at least so many bytes each. */
    int count(int entries, int leastBytes);

    /** A value that is stated by numbers; null is handed in where there is none yet. */
    <T> T value(Form<T> form, T value);
}
