package rigibo.web.library;

/** Random numbers, by the specified algorithm of Java's class of this name. */
public final class Random {

    private static final long FACTOR = 0x5deece66dL;
    private static final long SUMMAND = 0xbL;
    private static final int BITS = 48;
    private static final long MASK = (1L << BITS) - 1;

    /** The distance of two doubles below 1. */
    private static final double UNIT = 0x1.0p-53;

    private long seed;

    public Random(long seed) {
        this.seed = (seed ^ FACTOR) & MASK;
    }

    private int next(int bits) {
        seed = seed * FACTOR + SUMMAND & MASK;
        return (int) (seed >>> (BITS - bits));
    }

    public int nextInt() {
        return next(32);
    }

    /** A whole number from 0 to {@code bound}, excluded. */
    public int nextInt(int bound) {
        int drawn = next(31);
        int most = bound - 1;
        if ((bound & most) == 0) {
            return (int) (bound * (long) drawn >> 31);
        }
        int rest = drawn % bound;
        while (drawn - rest + most < 0) {
            drawn = next(31);
            rest = drawn % bound;
        }
        return rest;
    }

    public long nextLong() {
        return ((long) next(32) << 32) + next(32);
    }

    public boolean nextBoolean() {
        return next(1) != 0;
    }

    /** A number from 0 to 1, excluded. */
    public double nextDouble() {
        return (((long) next(26) << 27) + next(27)) * UNIT;
    }
}
