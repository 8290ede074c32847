package rigibo.lab.child;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;

import java.util.stream.IntStream;

class IntervalTest {

    private static final double ROUND_OFF = 1e-12;

    private static double[] upTo(int n) {
        return IntStream.rangeClosed(1, n).mapToDouble(i -> i).toArray();
    }

    /** All six on one side of the median: 2·(1/2)⁶ = 1/32. */
    @Test
    void sixValuesReachFromTheLeastToTheGreatest() {
        Interval interval = Interval.of(5, 1, 6, 3, 2, 4);
        assertThat(interval.median()).isEqualTo(3.5);
        assertThat(interval.low()).isEqualTo(1);
        assertThat(interval.high()).isEqualTo(6);
        assertThat(interval.coverage()).isCloseTo(1 - 1.0 / 32, within(ROUND_OFF));
    }

    /** P(X ≤ 5) = (1 + 20 + 190 + 1140 + 4845 + 15504)/2²⁰ = 21700/2²⁰ ≤ 0.025 < P(X ≤ 6). */
    @Test
    void twentyValuesReachFromTheSixthToTheFifteenth() {
        Interval interval = Interval.of(upTo(20));
        assertThat(interval.median()).isEqualTo(10.5);
        assertThat(interval.low()).isEqualTo(6);
        assertThat(interval.high()).isEqualTo(15);
        assertThat(interval.coverage()).isCloseTo(1 - 2 * 21700 / 1048576.0, within(ROUND_OFF));
    }

    /** 2·(1/2)⁵ = 1/16 is more than 5 %. */
    @Test
    void fiveValuesCoverLessAndSaySo() {
        Interval interval = Interval.of(upTo(5));
        assertThat(interval.median()).isEqualTo(3);
        assertThat(interval.low()).isEqualTo(1);
        assertThat(interval.high()).isEqualTo(5);
        assertThat(interval.coverage()).isCloseTo(1 - 1.0 / 16, within(ROUND_OFF));
    }

    @Test
    void oneValueCoversNothing() {
        Interval interval = Interval.of(7);
        assertThat(interval).isEqualTo(new Interval(7, 7, 7, 0));
    }

    @Test
    void isWithinOnlyWithBothEnds() {
        Interval interval = new Interval(1, 0.995, 1.008, 0.95);
        assertThat(interval.isWithin(0.01, 1)).isTrue();
        assertThat(interval.isWithin(0.006, 1)).isFalse();
        assertThat(interval.contains(1)).isTrue();
        assertThat(interval.contains(1.009)).isFalse();
    }
}
