package rigibo.backend.geometry;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import java.util.Random;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;

/** Elementary functions at special values, their symmetries, and that they never turn back. */
class ElementaryValuesTest {

    private static final double[] SPECIAL = {
        0,
        Double.MIN_VALUE,
        Double.MIN_NORMAL,
        1e-300,
        1e-17,
        0x1p-28,
        0x1p-27,
        0.5,
        0.75,
        Math.nextDown(1.0),
        1,
        Math.nextUp(1.0),
        Math.PI / 2,
        2,
        3,
        22,
        709.78,
        709.79,
        745.2,
        1e7,
        Math.nextUp(1e7),
        0x1p52 + 1,
        0x1p53,
        1e100,
        1e300,
        Double.MAX_VALUE,
        Double.POSITIVE_INFINITY,
        Double.NaN
    };

    /** Functions of one number, those of {@link StrictMath} beside ours. */
    private enum Unary {
        SIN(Angle::sin, StrictMath::sin, true),
        COS(Angle::cos, StrictMath::cos, false),
        ASIN(Angle::asin, StrictMath::asin, true),
        ACOS(Angle::acos, StrictMath::acos, false),
        EXP(Exponential::exp, StrictMath::exp, false),
        EXPM1(Exponential::expm1, StrictMath::expm1, false),
        TANH(Exponential::tanh, StrictMath::tanh, true),
        LOG(Logarithm::log, StrictMath::log, false);

        private final DoubleUnaryOperator ours;
        private final DoubleUnaryOperator strict;
        private final boolean isOdd;

        Unary(DoubleUnaryOperator ours, DoubleUnaryOperator strict, boolean isOdd) {
            this.ours = ours;
            this.strict = strict;
            this.isOdd = isOdd;
        }
    }

    private enum Binary {
        ATAN2(Angle::atan2, StrictMath::atan2),
        POW(Logarithm::pow, StrictMath::pow),
        HYPOT(Length::hypot, StrictMath::hypot);

        private final DoubleBinaryOperator ours;
        private final DoubleBinaryOperator strict;

        Binary(DoubleBinaryOperator ours, DoubleBinaryOperator strict) {
            this.ours = ours;
            this.strict = strict;
        }
    }

    @ParameterizedTest
    @EnumSource
    void functionOfOneNumberHasTheSpecialValuesOfTheJvm(Unary function) {
        for (double size : SPECIAL) {
            for (double x : new double[] {size, -size}) {
                double ours = function.ours.applyAsDouble(x);
                assertSame(ours, function.strict.applyAsDouble(x), "of " + x);
            }
        }
    }

    @ParameterizedTest
    @EnumSource
    void functionOfTwoNumbersHasTheSpecialValuesOfTheJvm(Binary function) {
        for (double first : SPECIAL) {
            for (double second : SPECIAL) {
                for (int signs = 0; signs < 4; signs++) {
                    double a = (signs & 1) == 0 ? first : -first;
                    double b = (signs & 2) == 0 ? second : -second;
                    double ours = function.ours.applyAsDouble(a, b);
                    assertSame(ours, function.strict.applyAsDouble(a, b), "of " + a + ", " + b);
                }
            }
        }
    }

    /** Zeros, infinities and NaN to the bit; where both round, they may be two units apart. */
    private static void assertSame(double ours, double strict, String of) {
        if (strict == 0 || !Double.isFinite(strict) || !Double.isFinite(ours)) {
            assertThat(Double.valueOf(ours)).as(of).isEqualTo(Double.valueOf(strict));
        } else {
            assertThat(Math.abs(ours - strict)).as(of).isLessThan(2 * Math.ulp(strict));
        }
    }

    @ParameterizedTest
    @EnumSource
    void isOddOrEvenToTheBit(Unary function) {
        Random random = new Random(7);
        for (int i = 0; i < 20_000; i++) {
            double x = random.nextGaussian() * Math.scalb(1.0, random.nextInt(60) - 40);
            Double there = function.ours.applyAsDouble(x);
            Double back = function.ours.applyAsDouble(-x);
            if (function.isOdd) {
                assertThat(back).isEqualTo(Double.valueOf(-there));
            } else if (function == Unary.COS) {
                assertThat(back).isEqualTo(there);
            }
        }
    }

    /** From one double to the next, also where one way of computing gives place to another. */
    @ParameterizedTest
    @EnumSource
    void neverTurnsBack(Unary function) {
        Random random = new Random(11);
        double[] borders = {0x1p-54, 0x1p-27, 0.125, 0.375, 0.625, 0.875, 0.34657359027997264, 1};
        for (int i = 0; i < 40_000; i++) {
            double border = borders[i % borders.length];
            double x =
                    i % 3 == 0
                            ? border - Math.ulp(border) * (1 + random.nextInt(50))
                            : random.nextDouble();
            double next = Math.nextUp(x);
            double step = function.ours.applyAsDouble(next) - function.ours.applyAsDouble(x);
            boolean isFalling = function == Unary.COS || function == Unary.ACOS;
            assertThat(isFalling ? step <= 0 : step >= 0).as("from %s", x).isTrue();
        }
    }

    @Test
    void directionNeverTurnsBack() {
        Random random = new Random(12);
        for (int i = 0; i < 40_000; i++) {
            double x = random.nextDouble();
            double y = i % 3 == 0 ? x * (random.nextInt(9) / 8.0) : random.nextDouble();
            assertThat(Angle.atan2(Math.nextUp(y), x)).isGreaterThanOrEqualTo(Angle.atan2(y, x));
            assertThat(Angle.atan2(y, Math.nextUp(x))).isLessThanOrEqualTo(Angle.atan2(y, x));
        }
    }

    /** A mirrored scene stays one. */
    @Test
    void directionOfAMirroredPointIsMirrored() {
        Random random = new Random(13);
        for (int i = 0; i < 20_000; i++) {
            double x = random.nextGaussian();
            double y = random.nextGaussian() * Math.scalb(1.0, random.nextInt(100) - 50);
            assertThat(Angle.atan2(-y, x)).isEqualTo(-Angle.atan2(y, x));
        }
    }

    @Test
    void wholePowersOfSmallWholeNumbersAreExact() {
        for (int base = 2; base <= 10; base++) {
            double product = 1;
            for (int power = 1; product * base < 0x1p53; power++) {
                product *= base;
                assertThat(Logarithm.pow(base, power)).isEqualTo(product);
                assertThat(Logarithm.pow(-base, power))
                        .isEqualTo(power % 2 == 0 ? product : -product);
            }
        }
    }
}
