package rigibo.fuzz.chance;

import rigibo.backend.geometry.Exponential;
import rigibo.backend.geometry.Logarithm;

import java.util.List;

/** Draws from a seed: the same calls give the same draws in every JVM and browser. */
public final class Chance {

    /** Spreads neighbouring seeds, whose first draws are alike: 2⁶⁴ over the golden ratio. */
    private static final long SPREAD = 0x9E3779B97F4A7C15L;

    /** What no door may take for an ordinary number. */
    private static final List<Double> NOT_FINITE =
            List.of(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY);

    private final Draws random;

    private Chance(long seed) {
        random = new Draws(seed);
    }

    /** The draws of one of the many things that a seed stands for. */
    public static Chance of(long seed, long index) {
        long mixed = (seed * SPREAD ^ index) * SPREAD;
        return new Chance(mixed ^ mixed >>> Integer.SIZE);
    }

    /** Evenly between two numbers. */
    public double between(double least, double most) {
        return least + (most - least) * random.nextDouble();
    }

    /** Between two positive numbers, every factor as likely as any other. */
    public double ofAnySize(double least, double most) {
        double drawn = Exponential.exp(between(Logarithm.log(least), Logarithm.log(most)));
        return Math.min(Math.max(drawn, least), most);
    }

    /** As {@link #ofAnySize}, then negated with a probability of one half. */
    public double ofEitherSign(double least, double most) {
        return random.nextBoolean() ? ofAnySize(least, most) : -ofAnySize(least, most);
    }

    /** A whole number from least to most. */
    public int whole(int least, int most) {
        return least + random.nextInt(most - least + 1);
    }

    /** Any 64 bits. */
    public long bits() {
        return random.nextLong();
    }

    /** Whether something of this probability happens. */
    public boolean happens(double probability) {
        return random.nextDouble() < probability;
    }

    /** One of several, each as likely. */
    public <T> T oneOf(List<T> choices) {
        return choices.get(random.nextInt(choices.size()));
    }

    /** One of several, each as likely. */
    @SafeVarargs
    public final <T> T oneOf(T... choices) {
        return choices[random.nextInt(choices.length)];
    }

    /** NaN or an infinity. */
    public double notFinite() {
        return oneOf(NOT_FINITE);
    }
}
