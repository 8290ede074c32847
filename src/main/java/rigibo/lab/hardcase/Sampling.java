package rigibo.lab.hardcase;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

/**
 * Which of a case's many variants are tried.
 *
 * @param extent how many
 * @param seed of what is drawn: another one tries variants that nobody has seen before
 */
public record Sampling(Extent extent, long seed) {

    /** More than any case has: no two variants of two seeds draw the same. */
    private static final long VARIANTS = 1_000_003;

    /** A few variants of the usual seed. */
    public static final Sampling USUAL = new Sampling(Extent.SMALL, 1);

    /** How many variants. */
    public enum Extent {
        /** So few that a case takes seconds. */
        SMALL,
        /** As many as the case's truth is stated for. */
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

    /** Draws for so many variants. */
    List<SplittableRandom> draws(int few, int all) {
        return IntStream.range(0, count(few, all)).mapToObj(this::random).toList();
    }

    /** Draws for one variant, which do not depend on the variants before. */
    SplittableRandom random(long variant) {
        return new SplittableRandom(seed * VARIANTS + variant);
    }
}
