package rigibo.fuzz.chance;

/**
 * The draws of {@code java.util.Random}, by the algorithms that its documentation states (D. Knuth,
 * The Art of Computer Programming, Volume 2, 1997, section 3.2.1). The class itself is another one
 * in browsers, where the same seed draws other numbers.
 */
final class Draws {

    private static final long FACTOR = 0x5DEECE66DL;
    private static final long SUMMAND = 0xBL;
    private static final int STATE_BITS = 48;
    private static final long STATE = (1L << STATE_BITS) - 1;

    private long state;

    Draws(long seed) {
        state = (seed ^ FACTOR) & STATE;
    }

    private int next(int bits) {
        state = state * FACTOR + SUMMAND & STATE;
        return (int) (state >>> STATE_BITS - bits);
    }

    /** A number uniform in [0, 1). */
    double nextDouble() {
        return (((long) next(26) << 27) + next(27)) * 0x1p-53;
    }

    boolean nextBoolean() {
        return next(1) != 0;
    }

    long nextLong() {
        return ((long) next(32) << 32) + next(32);
    }

    /** An integer uniform from 0 to a bound, which is excluded. */
    int nextInt(int bound) {
        if ((bound & -bound) == bound) {
            return (int) (bound * (long) next(31) >> 31);
        }
        int bits;
        int drawn;
        do {
            bits = next(31);
            drawn = bits % bound;
            // Numbers of the last, incomplete multiple of the bound are redrawn, since they would
            // favour small results.
        } while (bits - drawn + (bound - 1) < 0);
        return drawn;
    }
}
