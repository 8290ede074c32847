package rigibo.frontend.puzzle.generate;

import static org.assertj.core.api.Assertions.assertThat;

import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;

@Execution(ExecutionMode.CONCURRENT)
class ChanceTest {

    private static final int DRAWS = 10_000;

    private static List<Integer> draws(long seed, int attempt) {
        Chance chance = new Chance(seed, attempt);
        return IntStream.range(0, 8).map(i -> chance.below(1000)).boxed().toList();
    }

    @Test
    void sameSeedAndAttemptDrawTheSame() {
        assertThat(draws(7, 3)).isEqualTo(draws(7, 3));
    }

    @Test
    void otherSeedsAndOtherAttemptsDrawOtherNumbers() {
        assertThat(draws(7, 3)).isNotEqualTo(draws(8, 3)).isNotEqualTo(draws(7, 4));
    }

    /** The library's generator is SplitMix64 as well, and its long numbers are specified. */
    @Test
    void numbersAreThoseOfSplitMix64() {
        Chance chance = new Chance(0, 0);
        SplittableRandom library = new SplittableRandom(0);
        for (int i = 0; i < 100; i++) {
            assertThat((long) chance.below(1000))
                    .as("number %d", i)
                    .isEqualTo(Long.remainderUnsigned(library.nextLong(), 1000));
        }
    }

    @Test
    void lengthsAreWholeCentimetresBetweenBothBoundsAndReachThem() {
        Chance chance = new Chance(1, 0);
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < DRAWS; i++) {
            double length = chance.between(0.3, 0.4);
            assertThat(length * 100).isCloseTo(Math.rint(length * 100), within());
            least = Math.min(least, length);
            most = Math.max(most, length);
        }
        assertThat(least).isCloseTo(0.3, within());
        assertThat(most).isCloseTo(0.4, within());
    }

    /** The rounding of a sum of two decimal fractions. */
    private static Offset<Double> within() {
        return Offset.offset(1e-9);
    }

    /** Four standard deviations of a binomial count: 4·√(n·p·(1 − p)). */
    @Test
    void whatHappensInAShareOfAllCasesDoesSo() {
        Chance chance = new Chance(2, 0);
        long count = IntStream.range(0, DRAWS).filter(i -> chance.happens(30)).count();
        double deviation = Math.sqrt(DRAWS * 0.3 * 0.7);
        assertThat((double) count).isCloseTo(DRAWS * 0.3, Offset.offset(4 * deviation));
    }
}
