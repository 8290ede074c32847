package rigibo.frontend.scene.effects;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import rigibo.frontend.scene.Words;

class EstimateTest {

    private static final CostWords ENGLISH = new CostWords(new Words("en"));

    private static Estimate of(double... rounds) {
        Estimate estimate = new Estimate();
        for (double round : rounds) {
            estimate.add(round);
        }
        return estimate;
    }

    @Test
    void isTheMeanOfItsRounds() {
        assertThat(of(10, 12, 11, 9).mean()).isEqualTo(10.5);
    }

    @Test
    void forgetsWhatIsLongAgo() {
        Estimate estimate = of(7, 7, 7, 7, 7);
        for (int i = 0; i < Estimate.ROUNDS; i++) {
            estimate.add(3);
        }
        assertThat(estimate.mean()).isEqualTo(3);
        assertThat(estimate.noise()).isZero();
    }

    /** Squares 4, 1, 0, 1, 4 of five: a standard error of √(10/4/5). */
    @Test
    void itsNoiseIsTheMeansInterval() {
        assertThat(of(8, 9, 10, 11, 12).noise()).isCloseTo(2.31 * Math.sqrt(0.5), within(1e-12));
    }

    @Test
    void wordsClaimNoMoreThanWasMeasured() {
        assertThat(ENGLISH.ofLit(of(14000, 14000, 14000))).isEqualTo("costs 14.0 µs ± 0.00 µs");
        assertThat(ENGLISH.ofLit(of(-14000, -14000, -14000))).startsWith("saves 14.0 µs");
        assertThat(ENGLISH.ofLit(of(-900, 100, 1100)))
                .as("100 ns within ± %s", ENGLISH.time(of(-900, 100, 1100).noise()))
                .isEqualTo("costs less than the noise of 1.43 µs");
        assertThat(ENGLISH.ofUnlit(of(2e6, 2e6, 2e6)))
                .isEqualTo("would cost 2.00 ms ± 0.00 µs more");
    }

    @Test
    void timesAreShownInThreeDigits() {
        assertThat(ENGLISH.time(340)).isEqualTo("0.34 µs");
        assertThat(ENGLISH.time(3400)).isEqualTo("3.40 µs");
        assertThat(ENGLISH.time(34_000)).isEqualTo("34.0 µs");
        assertThat(ENGLISH.time(340_000)).isEqualTo("340 µs");
        assertThat(ENGLISH.time(3_400_000)).isEqualTo("3.40 ms");
    }
}
