package rigibo.backend.geometry;

/**
 * Functions of eˣ with the same bits everywhere. In 10⁶ arguments the largest errors are 0.76 units
 * in the last place of the true value of eˣ, 0.70 of tanh x and 0.86 of eˣ − 1 ({@code
 * ElementaryTest}).
 *
 * <p>With x = n·ln 2 + r and |r| ≤ ½ln 2, eˣ is 2ⁿ(1 + r + series). The sum 1 + r is kept exactly,
 * as a high and a low part. The series is Taylor's; its first omitted term is below 2⁻⁶⁴.
 *
 * <pre>{@code
 * double left = Exponential.exp(-0.5 * 3); // left after 3 s, if it decays at a rate of 0.5/s
 * }</pre>
 */
public final class Exponential {

    /** ln 2 in 42 bits, whose products with n are exact, and the rest. */
    private static final double LN_2_HIGH = 0x1.62e42fefa3800p-1;

    private static final double LN_2_LOW = 0x1.ef35793c76730p-45;
    private static final double ONE_OVER_LN_2 = 0x1.71547652b82fep0;

    /** Adding and then subtracting 1.5·2⁵² rounds a double to the nearest whole number. */
    private static final double ROUNDER = 0x1.8p52;

    /** Beyond these eˣ is infinite, or 0. */
    private static final double HIGHEST = 710;

    private static final double LOWEST = -746;

    /** Below it eˣ is lost beside 1. */
    private static final double HIDDEN = -38;

    /** Smaller numbers are their own eˣ − 1 and tanh x, to half a unit in the last place. */
    private static final double TINY = 0x1p-54;

    /** From here on e^−2x is lost beside 1. */
    private static final double FLAT = 22;

    private Exponential() {}

    /** Returns eˣ: infinite from 709.79 on, 0 below −745.14, NaN for NaN. */
    public static double exp(double x) {
        return exp(x, 0);
    }

    /** Returns e to the power of the sum of two parts. */
    static double exp(double x, double low) {
        if (!(x < HIGHEST)) {
            return x + Double.POSITIVE_INFINITY;
        }
        if (x < LOWEST) {
            return 0;
        }
        double n = turns(x);
        double r = rest(x, low, n);
        double sum = 1 + r;
        double value = sum + (Rounding.ofSum(1, r, sum) + (lack(x, low, n, r) + bend(r)));
        int half = (int) n / 2;
        return value * twoTo(half) * twoTo((int) n - half);
    }

    /** Returns eˣ − 1 without losing digits near 0; −0 for −0, NaN for NaN. */
    public static double expm1(double x) {
        if (!(x < HIGHEST) || x < HIDDEN) {
            return exp(x) - 1;
        }
        if (Math.abs(x) < TINY) {
            return x;
        }
        double n = turns(x);
        double r = rest(x, 0, n);
        if (n == 0) {
            return r + bend(r);
        }
        // Half of the power, since 2¹⁰²⁴ is not a double.
        double scale = twoTo((int) n - 1);
        double first = scale - 0.5;
        double second = scale * r;
        double sum = first + second;
        double lost = (scale - first - 0.5) + Rounding.ofSum(first, second, sum);
        return 2 * (sum + (lost + scale * (lack(x, 0, n, r) + bend(r))));
    }

    /** Returns (e²ˣ − 1)/(e²ˣ + 1), −1 to 1; −0 for −0, NaN for NaN. */
    public static double tanh(double x) {
        if (Math.abs(x) < TINY || !(Math.abs(x) < FLAT)) {
            return Math.abs(x) < FLAT || x != x ? x : Math.copySign(1, x);
        }
        double twice = 2 * Math.abs(x);
        double n = turns(twice);
        double r = rest(twice, 0, n);
        double scale = twoTo((int) n);
        double first = scale - 1;
        double second = scale * r;
        double sum = first + second;
        double small =
                Rounding.ofSum(first, second, sum) + scale * (lack(twice, 0, n, r) + bend(r));
        // Both e²ˣ − 1 and e²ˣ + 1 are kept as a high and a low part.
        double up = sum + small;
        double upLow = Rounding.ofSum(sum, small, up);
        double down = up + 2;
        double downLow = up < 2 ? Rounding.ofSum(2, up, down) : Rounding.ofSum(up, 2, down);
        double ratio = up / down;
        double back = ratio * down;
        double left = up - back - Rounding.ofProduct(ratio, down, back);
        ratio += (left + upLow - ratio * (downLow + upLow)) / down;
        return Math.copySign(ratio, x);
    }

    /** The whole number next to x/ln 2. */
    private static double turns(double x) {
        return x * ONE_OVER_LN_2 + ROUNDER - ROUNDER;
    }

    /** x + low − n·ln 2, rounded. */
    private static double rest(double x, double low, double n) {
        return (x - n * LN_2_HIGH) - (n * LN_2_LOW - low);
    }

    /** Rounding error of {@link #rest}. */
    private static double lack(double x, double low, double n, double rest) {
        return ((x - n * LN_2_HIGH) - rest) - (n * LN_2_LOW - low);
    }

    /** The Taylor series of eʳ − 1 − r. */
    private static double bend(double r) {
        double z = r * r;
        double zz = z * z;
        double four = 1.0 / 24 + r * (1.0 / 120);
        double six = 1.0 / 720 + r * (1.0 / 5040);
        double eight = 1.0 / 40320 + r * (1.0 / 362880);
        double ten = 1.0 / 3628800 + r * (1.0 / 39916800);
        double twelve = 1.0 / 479001600 + r * (1.0 / 6227020800.0);
        double fourteen = 1.0 / 87178291200.0 + r * (1.0 / 1307674368000.0);
        double later = four + z * six + zz * (eight + z * ten + zz * (twelve + z * fourteen));
        return 0.5 * z + z * (r * (1.0 / 6) + z * later);
    }

    /** A power of two that is a normal double. */
    private static double twoTo(int power) {
        return Double.longBitsToDouble((long) (power + 1023) << 52);
    }
}
