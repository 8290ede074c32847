package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.sun.management.ThreadMXBean;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.lang.management.ManagementFactory;
import java.util.Random;

/** {@link StrictMath} is within one unit in the last place of the truth, and so are we. */
class AngleTest {

    /** Angles of every size, from a thousandth of a radian to where doubles are far apart. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void isWithinAUnitInTheLastPlace(long seed) {
        Random random = new Random(seed);
        for (int i = 0; i < 300_000; i++) {
            double angle = (random.nextDouble() - 0.5) * 2 * Math.pow(10, random.nextInt(25) - 3);
            check(angle, "seed " + seed);
        }
    }

    /** Where the result is near 0 the reduction to a quarter turn must keep every bit. */
    @Test
    void isWithinAUnitNextToQuarterTurns() {
        for (int turns = 0; turns < 6_000_000; turns += 37) {
            double angle = turns * (Math.PI / 2);
            check(angle, "quarter turn " + turns);
            check(-Math.nextUp(angle), "quarter turn " + turns);
        }
    }

    private static void check(double angle, String where) {
        double sin = StrictMath.sin(angle);
        double cos = StrictMath.cos(angle);
        if (Math.abs(Angle.sin(angle) - sin) > Math.ulp(sin)
                || Math.abs(Angle.cos(angle) - cos) > Math.ulp(cos)) {
            assertThat(Angle.sin(angle)).as("sin %s, %s", angle, where).isEqualTo(sin);
            assertThat(Angle.cos(angle)).as("cos %s, %s", angle, where).isEqualTo(cos);
        }
    }

    @Test
    void isExactAtZero() {
        assertThat(Angle.sin(0)).isEqualTo(0);
        assertThat(Angle.cos(0)).isEqualTo(1);
        assertThat(Angle.sin(-1e-300)).isEqualTo(-1e-300);
    }

    /** A mirrored scene stays one: sine is odd and cosine even, to the bit. */
    @Test
    void isSymmetric() {
        Random random = new Random(3);
        for (int i = 0; i < 100_000; i++) {
            double angle = random.nextDouble() * 100;
            assertThat(Angle.sin(-angle)).isEqualTo(-Angle.sin(angle));
            assertThat(Angle.cos(-angle)).isEqualTo(Angle.cos(angle));
        }
    }

    /** However far apart the doubles are: a sine and a cosine of one and the same angle. */
    @ParameterizedTest
    @ValueSource(doubles = {1.0000001e7, -3e9, 1e22, -1e300, Double.MAX_VALUE})
    void hugeAnglesHaveASineAndACosine(double angle) {
        double sin = Angle.sin(angle);
        double cos = Angle.cos(angle);
        assertThat(sin * sin + cos * cos).isEqualTo(1, within(4e-16));
    }

    /** What turns fast enough does in every step; the sine of the JVM takes 696 bytes on some. */
    @Test
    void hugeAnglesAllocateNothing() {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        double sum = 0;
        long before = threads.getCurrentThreadAllocatedBytes();
        for (int i = 0; i < 100_000; i++) {
            sum += Angle.sin(1e9 + i) + Angle.cos(-1e12 - i);
        }
        long after = threads.getCurrentThreadAllocatedBytes();
        assertThat(sum).isFinite();
        assertThat(after - before).isLessThan(100_000);
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void whatIsNoAngleHasNoSine(double angle) {
        assertThat(Angle.sin(angle)).isNaN();
        assertThat(Angle.cos(angle)).isNaN();
    }

    @Test
    void rotationKeepsItsLength() {
        Random random = new Random(4);
        for (int i = 0; i < 10_000; i++) {
            double angle = random.nextDouble() * 1000;
            double sin = Angle.sin(angle);
            double cos = Angle.cos(angle);
            assertThat(sin * sin + cos * cos).isEqualTo(1, within(4e-16));
        }
    }
}
