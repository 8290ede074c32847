package rigibo.backend.geometry;

/**
 * Sine, cosine and their inverses with the same bits on every JVM and in every browser. {@link
 * Math#sin} does not promise that, and browsers have no {@link StrictMath}. All of it is made of
 * sums, products, quotients, roots and the bits of doubles. In 10⁶ arguments of all sizes the
 * largest error is 0.81 units in the last place of the true value ({@code ElementaryTest}).
 *
 * <p>An angle is reduced to [−π/4, π/4] by subtracting n·π/2, with π/2 in three parts (W. J. Cody
 * and W. Waite, Software Manual for the Elementary Functions, 1980); there the Taylor series is
 * evaluated. Next to a multiple of π/2 and from 10⁷ rad on, this would leave too few digits. There
 * the angle is reduced in whole numbers instead, with as many bits of 2/π as the largest double
 * needs.
 *
 * <pre>{@code
 * double height = 5 * Angle.sin(0.3); // m, the same bits everywhere
 * }</pre>
 */
public final class Angle {

    /** Largest angle in rad whose n·π/2 stays exact: n has 23 bits, the parts of π/2 have 30. */
    private static final double LARGEST = 1e7;

    /** Smaller angles are their own sines and tangents, and have a cosine of 1. */
    private static final double TINY = 0x1p-27;

    /**
     * Smallest reduced angle for which π/2 in three parts suffices: n times the last part has an
     * error of 2⁻⁹¹.
     */
    private static final double LEAST_LEFT = 0x1p-30;

    /**
     * Written out, since a library may round differently: it may multiply by π and then divide by
     * 180.
     */
    private static final double RADIANS_PER_DEGREE = 0.017453292519943295;

    private static final double DEGREES_PER_RADIAN = 57.29577951308232;

    /**
     * Coordinates of a direction between these powers of two need no scaling before they are
     * multiplied.
     */
    private static final int MODEST = 400;

    /** π/2 as two parts of 30 bits, whose products with n are exact, and the rest. */
    private static final double HALF_PI_HIGH = 0x1.921fb54p0;

    private static final double HALF_PI_MIDDLE = 0x1.10b46118p-30;
    private static final double HALF_PI_LOW = 0x1.313198a2e0370p-61;

    private static final double TWO_OVER_PI = 2 / Math.PI;

    /** Adding and then subtracting 1.5·2⁵² rounds a double to the nearest whole number. */
    private static final double ROUNDER = 0x1.8p52;

    /** Coefficients 1/k! of the two Taylor series, named by the power k. */
    private static final double TERM_3 = 1.0 / 6;

    private static final double TERM_4 = 1.0 / 24;
    private static final double TERM_5 = 1.0 / 120;
    private static final double TERM_6 = 1.0 / 720;
    private static final double TERM_7 = 1.0 / 5040;
    private static final double TERM_8 = 1.0 / 40320;
    private static final double TERM_9 = 1.0 / 362880;
    private static final double TERM_10 = 1.0 / 3628800;
    private static final double TERM_11 = 1.0 / 39916800;
    private static final double TERM_12 = 1.0 / 479001600;
    private static final double TERM_13 = 1.0 / 6227020800.0;
    private static final double TERM_14 = 1.0 / 87178291200.0;
    private static final double TERM_15 = 1.0 / 1307674368000.0;
    private static final double TERM_16 = 1.0 / 20922789888000.0;
    private static final double TERM_17 = 1.0 / 355687428096000.0;

    private Angle() {}

    /** Sine of an angle in rad; NaN when the angle is not finite, −0 for −0. */
    public static double sin(double angle) {
        return Math.abs(angle) < TINY ? angle : advanced(angle, 0);
    }

    /** Cosine of an angle in rad; NaN when the angle is not finite. */
    public static double cos(double angle) {
        return advanced(angle, 1);
    }

    /** Converts an angle from degrees to rad. */
    public static double ofDegrees(double degrees) {
        return degrees * RADIANS_PER_DEGREE;
    }

    /** Converts an angle from rad to degrees. */
    public static double inDegrees(double angle) {
        return angle * DEGREES_PER_RADIAN;
    }

    /**
     * Direction of the point (x, y) in rad, −π to π, counter-clockwise from the x axis. It has the
     * sign of y, even of a zero; for a y of zero and a negative x it is ±π. Where both are
     * infinite, it is a multiple of π/4; where one is NaN, it is NaN.
     */
    public static double atan2(double y, double x) {
        double up = Math.abs(y);
        double along = x;
        if (!(up <= Double.MAX_VALUE && Math.abs(x) <= Double.MAX_VALUE)) {
            if (y != y || x != x) {
                return Double.NaN;
            }
            // An infinite coordinate counts as 1, and a finite one beside it as 0.
            up = Double.isInfinite(y) ? 1 : 0;
            along = Math.copySign(Double.isInfinite(x) ? 1 : 0, x);
        }
        if (up == 0) {
            return Math.copySign(Math.copySign(1, along) < 0 ? Math.PI : 0, y);
        }
        int size = Math.getExponent(Math.max(up, Math.abs(along)));
        if (size > MODEST || size < -MODEST) {
            if (along > 0 && up < along * 0x1p-60) {
                return y / x;
            }
            double scale = size > 0 ? 0x1p-600 : 0x1p600;
            up *= scale;
            along *= scale;
        }
        return Math.copySign(ArcTangent.of(up, 0, along, 0), y);
    }

    /** Angle in rad, −π/2 to π/2, whose sine is given; NaN beyond −1 and 1, −0 for −0. */
    public static double asin(double sine) {
        if (Math.abs(sine) < TINY) {
            return sine;
        }
        double square = squareBeside(sine);
        double other = Math.sqrt(square);
        double angle = ArcTangent.of(Math.abs(sine), 0, other, rootLack(sine, square, other));
        return Math.copySign(angle, sine);
    }

    /** Angle in rad, 0 to π, whose cosine is given; NaN beyond −1 and 1. */
    public static double acos(double cosine) {
        double square = squareBeside(cosine);
        double other = Math.sqrt(square);
        return ArcTangent.of(other, rootLack(cosine, square, other), cosine, 0);
    }

    /** 1 − c², rounded. */
    private static double squareBeside(double c) {
        double size = Math.abs(c);
        return (1 - size) * (1 + size);
    }

    /** Rounding error of √(1 − c²), by one step of Newton's method. */
    private static double rootLack(double c, double square, double root) {
        if (square == 0) {
            return 0;
        }
        double size = Math.abs(c);
        double less = 1 - size;
        double more = 1 + size;
        double lost = Rounding.ofProduct(less, more, square);
        lost += less * Rounding.ofSum(1, size, more) + more * Rounding.ofSum(1, -size, less);
        double back = root * root;
        return (square - back - Rounding.ofProduct(root, root, back) + lost) / (2 * root);
    }

    /** Sine of an angle plus {@code quadrant} quarter turns. */
    private static double advanced(double angle, int quadrant) {
        if (!(Math.abs(angle) <= LARGEST)) {
            return QuarterTurns.sine(angle, quadrant);
        }
        double turns = angle * TWO_OVER_PI + ROUNDER - ROUNDER;
        double high = angle - turns * HALF_PI_HIGH;
        double middle = turns * HALF_PI_MIDDLE;
        double sum = high - middle;
        if (Math.abs(sum) < LEAST_LEFT && turns != 0) {
            return QuarterTurns.sine(angle, quadrant);
        }
        // Knuth's two-sum: the rounding error of the subtraction, whichever operand is larger.
        double back = high - sum;
        double lost = (high - (sum + back)) + (back - middle);
        double low = turns * HALF_PI_LOW - lost;
        double x = sum - low;
        return quarter((int) turns + quadrant, x, (sum - x) - low);
    }

    /** Sine of x + tail, at most π/4, plus {@code quadrant} quarter turns. */
    static double quarter(int quadrant, double x, double tail) {
        double value = (quadrant & 1) == 0 ? sineOf(x, tail) : cosineOf(x, tail);
        return (quadrant & 2) == 0 ? value : -value;
    }

    /** Taylor series of sin(x + tail) for |x| up to π/4; the first omitted term is below 1e-19. */
    private static double sineOf(double x, double tail) {
        double z = x * x;
        double zz = z * z;
        double even = TERM_5 + zz * (TERM_9 + zz * (TERM_13 + zz * TERM_17));
        double odd = TERM_7 + zz * (TERM_11 + zz * TERM_15);
        double series = TERM_3 - z * (even - z * odd);
        return x + (tail - x * (z * series + x * tail / 2));
    }

    /** Taylor series of cos(x + tail) for |x| up to π/4; the first omitted term is below 1e-17. */
    private static double cosineOf(double x, double tail) {
        double z = x * x;
        double zz = z * z;
        double even = TERM_4 + zz * (TERM_8 + zz * (TERM_12 + zz * TERM_16));
        double odd = TERM_6 + zz * (TERM_10 + zz * TERM_14);
        double half = z / 2;
        double whole = 1 - half;
        // The rounding error of 1 − z/2 is added back together with the small terms.
        return whole + ((1 - whole - half) + (zz * (even - z * odd) - x * tail));
    }
}
