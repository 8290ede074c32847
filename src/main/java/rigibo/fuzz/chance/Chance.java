package rigibo.fuzz.chance;

import rigibo.backend.geometry.Exponential;
import rigibo.backend.geometry.Logarithm;

import java.util.List;
import java.util.Random;

/** Random draws from a seed. The same calls give the same draws in every JVM and browser. */
public final class Chance {

    /**
     * A factor that spreads neighbouring seeds, whose first draws would be alike: 2⁶⁴ over the
     * golden ratio.
     */
    private static final long SPREAD = 0x9E3779B97F4A7C15L;

    /** Numbers that the engine must refuse. */
    private static final List<Double> NOT_FINITE =
            List.of(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY);

    private final Random random;

    private Chance(long seed) {
        random = new Random(seed);
    }

    /** The draws for the input with an index among those of a seed. */
    public static Chance of(long seed, long index) {
        long mixed = (seed * SPREAD ^ index) * SPREAD;
        return new Chance(mixed ^ mixed >>> Integer.SIZE);
    }

    /** A number uniform between two others. */
    public double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }

    /** A number between two positive ones, uniform in the logarithm. */
    public double ofAnySize(double least, double most) {
        double drawn = Exponential.exp(between(Logarithm.log(least), Logarithm.log(most)));
        return Math.min(Math.max(drawn, least), most);
    }

    /** A number like that of {@link #ofAnySize}, negated with probability one half. */
    public double ofEitherSign(double least, double most) {
        return random.nextBoolean() ? ofAnySize(least, most) : -ofAnySize(least, most);
    }

    /** An integer between two others. */
    public int whole(int least, int most) {
        return least + random.nextInt(most - least + 1);
    }

    /** Any 64 bits. */
    public long bits() {
        return random.nextLong();
    }

    /** Returns true with a probability. */
    public boolean happens(double probability) {
        return random.nextDouble() < probability;
    }

    /** One of several, all equally likely. */
    public <T> T oneOf(List<T> choices) {
        return choices.get(random.nextInt(choices.size()));
    }

    /** One of several, all equally likely. */
    @SafeVarargs
    public final <T> T oneOf(T... choices) {
        return choices[random.nextInt(choices.length)];
    }

    /** NaN or an infinity. */
    public double notFinite() {
        return oneOf(NOT_FINITE);
    }
}
