package rigibo.backend.geometry;

/**
 * Logarithm and power with the same bits everywhere. In 10⁶ arguments the largest errors are 0.53
 * units in the last place of the true value of ln x, and 0.75 of xʸ ({@code ElementaryTest}).
 *
 * <p>With x = 2ᵏm, m between √½ and √2, and s = (m − 1)/(m + 1), ln x is k·ln 2 + 2s + s·series.
 * The series is that of the inverse of tanh in s² ≤ 0.0295; its first omitted term is below 2⁻⁶³. A
 * power multiplies the logarithm by up to 10³ before the exponential, which would magnify its
 * error. So it takes the logarithm as a high and a low part, with a relative error of 2⁻⁶⁷.
 *
 * <pre>{@code
 * double times = Logarithm.log(8) / Logarithm.log(2); // 3
 * }</pre>
 */
public final class Logarithm {

    /** ln 2 in 42 bits, whose products with a double's exponent are exact, and the rest. */
    private static final double LN_2_HIGH = 0x1.62e42fefa3800p-1;

    private static final double LN_2_LOW = 0x1.ef35793c76730p-45;

    /** ⅔ as a high and a low part. */
    private static final double TWO_THIRDS_HIGH = 0x1.5555555555555p-1;

    private static final double TWO_THIRDS_LOW = 0x1.5555555555555p-55;

    /** The bits of √½, whose exponent is −1. */
    private static final long ROOT_OF_HALF = 0x3fe6a09e667f3bcdL;

    /** Makes the smallest doubles normal. */
    private static final double SCALE = 0x1p54;

    private static final int SCALE_POWER = 54;

    /** Beyond these, eˣ is infinite or 0 whatever the low part is. */
    private static final double FARTHEST = 800;

    private Logarithm() {}

    /** Returns ln x: −∞ for 0, NaN below, +∞ for +∞, NaN for NaN. */
    public static double log(double x) {
        if (!(x > 0 && x <= Double.MAX_VALUE)) {
            return x == 0 ? Double.NEGATIVE_INFINITY : x < 0 ? Double.NaN : x;
        }
        int power = power(x);
        double up = part(x, power) - 1;
        double down = 2 + up;
        double s = up / down;
        double z = s * s;
        double base = power * LN_2_HIGH;
        double sum = base + 2 * s;
        double lost = power == 0 ? 0 : Rounding.ofSum(base, 2 * s, sum);
        double small = 2 * quotientLack(up, down, s) + s * (z * (TWO_THIRDS_HIGH + later(z)));
        return sum + (lost + (power * LN_2_LOW + small));
    }

    /**
     * Returns x to the power of y, by the rules of {@link StrictMath#pow}. It is 1 for a y of 0,
     * and otherwise NaN when a number is NaN. A negative x needs a whole y; an odd y keeps the
     * sign.
     */
    public static double pow(double x, double y) {
        if (y == 0) {
            return 1;
        }
        if (x != x || y != y) {
            return Double.NaN;
        }
        double size = Math.abs(x);
        boolean isWhole = y == Math.floor(y);
        boolean isOdd = isWhole && Math.abs(y) < 0x1p53 && ((long) y & 1) == 1;
        if (x < 0 && !isWhole && size <= Double.MAX_VALUE && !Double.isInfinite(y)) {
            return Double.NaN;
        }
        double sign = isOdd && Math.copySign(1, x) < 0 ? -1 : 1;
        return sign * ofSize(size, y);
    }

    /** The power of a number of 0 or more. */
    private static double ofSize(double size, double y) {
        if (size == 1) {
            return Double.isInfinite(y) ? Double.NaN : 1;
        }
        if (size == 0 || Double.isInfinite(size) || Double.isInfinite(y)) {
            return size > 1 == y > 0 ? Double.POSITIVE_INFINITY : 0;
        }
        return ofFinite(size, y);
    }

    private static double ofFinite(double size, double y) {
        int power = power(size);
        double up = part(size, power) - 1;
        double down = 2 + up;
        double s = up / down;
        double sLow = quotientLack(up, down, s);
        double z = s * s;
        double zLow = Rounding.ofProduct(s, s, z) + 2 * s * sLow;
        double later = later(z);
        double series = TWO_THIRDS_HIGH + later;
        double seriesLow = Rounding.ofSum(TWO_THIRDS_HIGH, later, series) + TWO_THIRDS_LOW;
        double bent = z * series;
        double bentLow = Rounding.ofProduct(z, series, bent) + z * seriesLow + zLow * series;
        double more = s * bent;
        double moreLow = Rounding.ofProduct(s, bent, more) + s * bentLow + sLow * (2 + bent);
        double base = power * LN_2_HIGH;
        double sum = base + 2 * s;
        double lost = power == 0 ? 0 : Rounding.ofSum(base, 2 * s, sum);
        double most = sum + more;
        double rest = Rounding.ofSum(sum, more, most) + (lost + (moreLow + power * LN_2_LOW));
        double high = most + rest;
        double low = Rounding.ofSum(most, rest, high);
        double exponent = y * high;
        if (!(Math.abs(exponent) < FARTHEST)) {
            return exponent > 0 ? Double.POSITIVE_INFINITY : 0;
        }
        return Exponential.exp(exponent, Rounding.ofProduct(y, high, exponent) + y * low);
    }

    /** The k for which x = 2ᵏm, with m from √½ to √2. */
    private static int power(double x) {
        return x < Double.MIN_NORMAL
                ? power(x * SCALE) - SCALE_POWER
                : (int) (Double.doubleToRawLongBits(x) - ROOT_OF_HALF >> 52);
    }

    /** That m. */
    private static double part(double x, int power) {
        return x < Double.MIN_NORMAL
                ? part(x * SCALE, power + SCALE_POWER)
                : Double.longBitsToDouble(Double.doubleToRawLongBits(x) - ((long) power << 52));
    }

    /** Rounding error of the quotient s, whose denominator is its numerator plus 2. */
    private static double quotientLack(double up, double down, double s) {
        double back = s * down;
        double left = up - back - Rounding.ofProduct(s, down, back);
        return (left - s * Rounding.ofSum(2, up, down)) / down;
    }

    /** The terms ⅖z + ²⁄₇z² + … of the series, after its first, ⅔. */
    private static double later(double z) {
        double zz = z * z;
        double odd = 2.0 / 13 + zz * (2.0 / 17 + zz * (2.0 / 21 + zz * (2.0 / 25)));
        double even =
                2.0 / 7 + zz * (2.0 / 11 + zz * (2.0 / 15 + zz * (2.0 / 19 + zz * (2.0 / 23))));
        return z * (2.0 / 5 + zz * (2.0 / 9 + zz * odd) + z * even);
    }
}
