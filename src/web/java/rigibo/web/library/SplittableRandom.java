package rigibo.web.library;

import java.util.stream.DoubleStream;

/**
 * Random numbers, by the algorithm of Java's class of this name: Steele, Lea, Flood, Fast
 * Splittable Pseudorandom Number Generators, 2014.
 */
public final class SplittableRandom {

    private static final long GOLDEN = 0x9e3779b97f4a7c15L;

    /** The distance of two doubles below 1. */
    private static final double UNIT = 0x1.0p-53;

    private long seed;

    public SplittableRandom(long seed) {
        this.seed = seed;
    }

    private long nextSeed() {
        seed += GOLDEN;
        return seed;
    }

    private long nextLong() {
        long mixed = nextSeed();
        mixed = (mixed ^ (mixed >>> 30)) * 0xbf58476d1ce4e5b9L;
        mixed = (mixed ^ (mixed >>> 27)) * 0x94d049bb133111ebL;
        return mixed ^ (mixed >>> 31);
    }

    private int nextInt() {
        long mixed = nextSeed();
        mixed = (mixed ^ (mixed >>> 33)) * 0x62a9d9ed799705f5L;
        return (int) (((mixed ^ (mixed >>> 28)) * 0xcb24d0a5c88c35b3L) >>> 32);
    }

    /** A whole number from 0 to {@code bound}, excluded. */
    public int nextInt(int bound) {
        int mask = bound - 1;
        int drawn = nextInt();
        if ((bound & mask) == 0) {
            return drawn & mask;
        }
        int positive = drawn >>> 1;
        int rest = positive % bound;
        while (positive + mask - rest < 0) {
            positive = nextInt() >>> 1;
            rest = positive % bound;
        }
        return rest;
    }

    public boolean nextBoolean() {
        return nextInt() < 0;
    }

    /** {@code count} numbers from 0 to 1, excluded. */
    public DoubleStream doubles(long count) {
        return DoubleStream.generate(this::nextDouble).limit(count);
    }

    /** A number from 0 to 1, excluded. */
    public double nextDouble() {
        return (nextLong() >>> 11) * UNIT;
    }

    /** A number from {@code least} to {@code bound}, excluded. */
    public double nextDouble(double least, double bound) {
        double drawn = nextDouble() * (bound - least) + least;
        return drawn < bound ? drawn : Math.nextDown(bound);
    }
}
