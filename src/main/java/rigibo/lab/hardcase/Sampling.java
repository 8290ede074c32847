package rigibo.lab.hardcase;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/**
 * The choice among the variants of a case.
 *
 * @param extent how many are run
 * @param seed of random variants
 */
public record Sampling(Extent extent, long seed) {

    /** More variants than any case has, so that variants of different seeds never coincide. */
    private static final long VARIANTS = 1_000_003;

    /** A few variants of the usual seed. */
    public static final Sampling USUAL = new Sampling(Extent.SMALL, 1);

    /** How many variants. */
    public enum Extent {
        /** So few that a case takes seconds. */
        SMALL,
        /** All that the case's truth is stated for. */
        FULL
    }

    /** The variants to try. */
    <T> List<T> of(List<T> few, List<T> all) {
        return extent == Extent.FULL ? all : few;
    }

    /** How many variants to draw. */
    int count(int few, int all) {
        return extent == Extent.FULL ? all : few;
    }

    /** A random source for each of a number of variants. */
    List<SplittableRandom> draws(int few, int all) {
        return IntStream.range(0, count(few, all)).mapToObj(this::random).toList();
    }

    /** A random source for one variant, independent of the variants before. */
    SplittableRandom random(long variant) {
        return new SplittableRandom(seed * VARIANTS + variant);
    }
}
