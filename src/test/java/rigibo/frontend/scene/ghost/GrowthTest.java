package rigibo.frontend.scene.ghost;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import java.util.function.DoubleUnaryOperator;

/** Chaos is told from errors that add up and from worlds that part at once. */
class GrowthTest {

    private static final double SIZE = 2;

    private static boolean isExponential(DoubleUnaryOperator distance) {
        Growth growth = new Growth();
        for (int i = 1; !growth.hasReached(SIZE); i++) {
            growth.add(distance.applyAsDouble(i / 60.0));
        }
        return growth.isExponential();
    }

    @Test
    void exponentialsAreChaos() {
        assertThat(isExponential(t -> 1e-9 * Math.exp(3 * t))).isTrue();
        assertThat(isExponential(t -> 1e-4 * Math.exp(0.5 * t))).isTrue();
    }

    /** An impact every half second, each of which makes ten times of it. */
    @Test
    void stairsOfImpactsAreChaos() {
        assertThat(isExponential(t -> 1e-7 * Math.pow(10, Math.floor(2 * t)))).isTrue();
    }

    @Test
    void powersOfTimeAreNoChaos() {
        for (int power = 1; power <= 3; power++) {
            double exponent = power;
            assertThat(isExponential(t -> 0.02 * Math.pow(t, exponent))).as("t^" + power).isFalse();
        }
    }

    /** A box that tips in one world and stays in the other. */
    @Test
    void oneJumpIsNoChaos() {
        for (double when : new double[] {0.5, 2, 8}) {
            assertThat(isExponential(t -> t < when ? 1e-9 : t < 2 * when ? 0.4 : 1)).isFalse();
        }
    }

    @Test
    void equalWorldsNeverPart() {
        Growth growth = new Growth();
        for (int i = 0; i < 10_000; i++) {
            growth.add(0);
        }
        assertThat(growth.hasReached(SIZE)).isFalse();
        assertThat(growth.isExponential()).isFalse();
    }
}
