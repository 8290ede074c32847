package rigibo.lab.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

class GrowthTest {

    @Test
    void exponentOfAPowerIsThatPower() {
        double[] sizes = {1000, 3000, 50_000};
        double[] times = new double[sizes.length];
        for (int i = 0; i < sizes.length; i++) {
            times[i] = 3 * Math.pow(sizes[i], 1.25);
        }
        assertThat(Growth.exponent(sizes, times)).isCloseTo(1.25, within(1e-12));
    }

    /** x = 0, 1, 2 and y = 0, 1, 3: Σ(x − 1)(y − 4/3) = 3, Σ(x − 1)² = 2. */
    @Test
    void exponentFitsByLeastSquaresOnLogarithms() {
        double e = Math.E;
        double[] sizes = {1, e, e * e};
        double[] times = {1, e, e * e * e};
        assertThat(Growth.exponent(sizes, times)).isCloseTo(1.5, within(1e-12));
    }
}
