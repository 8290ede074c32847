package rigibo.backend.geometry;

/**
 * Sine and cosine with the same bits on every JVM. {@link Math#sin} does not promise that; {@link
 * StrictMath#sin} does, but is slower.
 *
 * <p>The angle is reduced to [−π/4, π/4] by subtracting n·π/2, with π/2 in three parts (W. J. Cody
 * and W. Waite, Software Manual for the Elementary Functions, 1980); there the Taylor series is
 * evaluated. The result is within one unit in the last place of the true value, or within 10⁻²⁷
 * where that is nearly 0.
 *
 * <p>From 10⁷ rad on, doubles are 10⁻⁹ rad apart or more. There whole turns are subtracted first,
 * with the double next to 2π; the error that this adds to the angle is less than the distance to
 * the next double. {@link StrictMath} would be exact there, but allocates on some JVMs.
 *
 * <pre>{@code
 * double height = 5 * Angle.sin(0.3); // m, the same bits everywhere
 * }</pre>
 */
public final class Angle {

    /** Largest angle in rad whose n·π/2 stays exact: n has 23 bits, the parts of π/2 have 30. */
    private static final double LARGEST = 1e7;

    /** π/2 as two parts of 30 bits, whose products with n are exact, and the rest. */
    private static final double HALF_PI_HIGH = 0x1.921fb54p0;

    private static final double HALF_PI_MIDDLE = 0x1.10b46118p-30;
    private static final double HALF_PI_LOW = 0x1.313198a2e0370p-61;

    private static final double TWO_OVER_PI = 2 / Math.PI;
    private static final double TWO_PI = 2 * Math.PI;

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

    /** Sine of an angle in rad; NaN when the angle is not finite. */
    public static double sin(double angle) {
        double less = withoutTurns(angle);
        double turns = less * TWO_OVER_PI + ROUNDER - ROUNDER;
        return quarter((int) turns, less, turns);
    }

    /** Cosine of an angle in rad; NaN when the angle is not finite. */
    public static double cos(double angle) {
        double less = withoutTurns(angle);
        double turns = less * TWO_OVER_PI + ROUNDER - ROUNDER;
        return quarter((int) turns + 1, less, turns);
    }

    /**
     * Subtracts whole turns from a large angle. The remainder is exact; the rounding of 2π shifts
     * it once per turn.
     */
    private static double withoutTurns(double angle) {
        return Math.abs(angle) <= LARGEST ? angle : angle % TWO_PI;
    }

    /**
     * Sine of the remainder of an angle after {@code turns} quarter turns, plus {@code quadrant}
     * quarter turns.
     */
    private static double quarter(int quadrant, double angle, double turns) {
        double high = angle - turns * HALF_PI_HIGH;
        double middle = turns * HALF_PI_MIDDLE;
        double sum = high - middle;
        // Knuth's two-sum: the rounding error of the subtraction, whichever operand is larger.
        double back = high - sum;
        double lost = (high - (sum + back)) + (back - middle);
        double low = turns * HALF_PI_LOW - lost;
        double x = sum - low;
        double tail = (sum - x) - low;
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
