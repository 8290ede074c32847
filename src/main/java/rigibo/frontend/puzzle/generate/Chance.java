package rigibo.frontend.puzzle.generate;

import java.util.List;

/**
 * Random numbers from a seed, with the same bits on every Java and in browsers: SplitMix64 (Steele,
 * Lea and Flood, Fast splittable pseudorandom number generators, 2014). The library's generators
 * specify their bits, but not how they derive numbers of a range.
 */
final class Chance {

    private static final long GOLDEN = 0x9e3779b97f4a7c15L;

    /** Lengths are drawn in steps of a centimetre, so that files stay readable. */
    private static final double PER_METRE = 100;

    private static final int PERCENT = 100;

    private long state;

    /** The numbers of one attempt with a seed. */
    Chance(long seed, int attempt) {
        state = mix(seed) + mix(attempt * GOLDEN);
    }

    private static long mix(long bits) {
        long mixed = (bits ^ bits >>> 30) * 0xbf58476d1ce4e5b9L;
        mixed = (mixed ^ mixed >>> 27) * 0x94d049bb133111ebL;
        return mixed ^ mixed >>> 31;
    }

    private long next() {
        state += GOLDEN;
        return mix(state);
    }

    /** A whole number from 0, less than {@code count}. */
    int below(int count) {
        return (int) Long.remainderUnsigned(next(), count);
    }

    /** A length in whole centimetres, both bounds included, m. */
    double between(double least, double most) {
        int steps = (int) Math.round((most - least) * PER_METRE);
        return least + below(steps + 1) / PER_METRE;
    }

    /** Whether an event of this probability in {@code percent} happens. */
    boolean happens(int percent) {
        return below(PERCENT) < percent;
    }

    <T> T oneOf(List<T> choices) {
        return choices.get(below(choices.size()));
    }
}
