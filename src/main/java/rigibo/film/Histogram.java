package rigibo.film;

/**
 * How often colours occur, in bins of 128 steps a channel: finer differences are not seen, and more
 * bins would only take longer.
 */
final class Histogram {

    static final int BITS = 7;
    static final int BINS = 1 << 3 * BITS;
    private static final int DROPPED = 8 - BITS;
    private static final int MASK = (1 << BITS) - 1;

    private final int[] counts = new int[BINS];

    void add(Frame frame) {
        for (int color : frame.colors()) {
            counts[bin(color)]++;
        }
    }

    int count(int bin) {
        return counts[bin];
    }

    static int bin(int color) {
        int red = color >> 16 + DROPPED & MASK;
        int green = color >> 8 + DROPPED & MASK;
        int blue = color >> DROPPED & MASK;
        return red << 2 * BITS | green << BITS | blue;
    }

    /** The middle of a bin on a channel: 0 red, 1 green, 2 blue; 0 to 255. */
    static int level(int bin, int channel) {
        int step = bin >> (2 - channel) * BITS & MASK;
        return (step << DROPPED) + (1 << DROPPED >> 1);
    }
}
