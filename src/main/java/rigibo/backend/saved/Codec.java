package rigibo.backend.saved;

/**
 * Processes the values of a state one by one. Each method receives the present value and returns
 * the value to keep: a writer or a hash returns the same one, a reader the one that was written. So
 * a single description of the state serves writing, reading and hashing, and none of them can leave
 * anything out.
 */
interface Codec {

    /** Names the values that follow, in ASCII; a reader rejects any other name in its place. */
    void label(String name);

    /**
     * Whether to process the column of a declared effect; {@code rows} are its slots in use. While
     * the effect does nothing, the column equals {@code idle}, or 0 where {@code idle} is null.
     */
    default boolean keeps(String name, double[] column, double[] idle, int[] rows) {
        return true;
    }

    int number(int value);

    double number(double value);

    boolean flag(boolean value);

    String text(String value);

    /** The number of entries that follow, each of at least {@code leastBytes} bytes. */
    int count(int entries, int leastBytes);

    /** A value that is made of numbers; a reader receives null where there is none yet. */
    <T> T value(Form<T> form, T value);
}
