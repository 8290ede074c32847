package rigibo.backend.geometry;

/**
 * Sine and cosine of angles whose quarter turns cannot be subtracted in doubles: huge angles, and
 * those next to a multiple of π/2 (M. Payne and R. Hanek, Radian Reduction for Trigonometric
 * Functions, 1983). The angle is a whole number m times a power of two, and only m·2/π modulo 4
 * matters. So the leading bits of 2/π are left out, and 192 bits are enough: 139 of them remain
 * behind the binary point, and no double but 0 is closer than 2⁻⁶² to a multiple of π/2.
 */
final class QuarterTurns {

    /** 2/π in binary, 64 bits in each word. The first word is the whole part. */
    private static final long[] TWO_OVER_PI = {
        0,
        0xa2f9836e4e441529L,
        0xfc2757d1f534ddc0L,
        0xdb6295993c439041L,
        0xfe5163abdebbc561L,
        0xb7246e3a424dd2e0L,
        0x06492eea09d1921cL,
        0xfe1deb1cb129a73eL,
        0xe88235f52ebb4484L,
        0xe99c7026b45f7e41L,
        0x3991d639835339f4L,
        0x9c845f8bbdf9283bL,
        0x1ff897ffde05980fL,
        0xef2f118b5a0a6d1fL,
        0x6d367ecf27cb09b7L,
        0x4f463f669e5fea2dL,
        0x7527bac7ebe5f17bL,
        0x3d0739f78a5292eaL,
        0x6bfb5fb11f8d5d08L,
        0x56033046fc7b6babL
    };

    /** π/2 as a high and a low part. */
    private static final double HALF_PI_HIGH = 0x1.921fb54442d18p0;

    private static final double HALF_PI_LOW = 0x1.1a62633145c07p-54;

    /** Bits of a double's fraction, and the exponent that stands for 2⁰. */
    private static final int FRACTION_BITS = 52;

    private static final int BIAS = 1023;
    private static final long FRACTION = (1L << FRACTION_BITS) - 1;
    private static final long LOWER_HALF = 0xffffffffL;

    private QuarterTurns() {}

    /**
     * Sine of an angle and {@code more} quarter turns.
     *
     * @param angle rad, of a magnitude of ½ or more; NaN is returned when it is not finite
     */
    static double sine(double angle, int more) {
        if (!(Math.abs(angle) <= Double.MAX_VALUE)) {
            return Double.NaN;
        }
        long bits = Double.doubleToRawLongBits(Math.abs(angle));
        long whole = bits & FRACTION | FRACTION + 1;
        int exponent = (int) (bits >>> FRACTION_BITS) - BIAS - FRACTION_BITS;
        // The first bit of 2/π whose product with the angle is no multiple of 4.
        int first = 64 + exponent - 2;
        long w0 = word(first);
        long w1 = word(first + 64);
        long w2 = word(first + 128);
        long p1 = whole * w1;
        long r1 = p1 + high(whole, w2);
        long carry = Long.compareUnsigned(r1, p1) < 0 ? 1 : 0;
        long r0 = whole * w0 + high(whole, w1) + carry;
        // r0 begins with two bits in front of the point; a fraction of a half or more counts as −½.
        long fraction = r0 << 2 | r1 >>> 62;
        int quarters = (int) (r0 >>> 62) + (fraction < 0 ? 1 : 0);
        double sign = angle < 0 ? -1 : 1;
        return sine(fraction, r1 << 2, sign, angle < 0 ? more - quarters : more + quarters);
    }

    /** 64 bits of 2/π from bit {@code first} on. */
    private static long word(int first) {
        int at = first >> 6;
        int shift = first & 63;
        return shift == 0
                ? TWO_OVER_PI[at]
                : TWO_OVER_PI[at] << shift | TWO_OVER_PI[at + 1] >>> 64 - shift;
    }

    /** The upper 64 bits of the product of a number below 2⁵³ and an unsigned one. */
    private static long high(long whole, long word) {
        long low = whole & LOWER_HALF;
        long high = whole >>> 32;
        long middle = high * (word & LOWER_HALF) + (low * (word & LOWER_HALF) >>> 32);
        long other = low * (word >>> 32) + (middle & LOWER_HALF);
        return high * (word >>> 32) + (middle >>> 32) + (other >>> 32);
    }

    /** Sine of whole quarter turns plus or minus a fraction of one, in units of 2⁻¹²⁸. */
    private static double sine(long fraction, long rest, double sign, int quarters) {
        int zeros = Math.min(63, Long.numberOfLeadingZeros(fraction ^ fraction >> 63)) - 1;
        long digits = zeros == 0 ? fraction : fraction << zeros | rest >>> 64 - zeros;
        // Both halves are exact as doubles.
        double upper = (digits >> 32) * 0x1p32;
        double lower = digits & LOWER_HALF;
        double high = upper + lower;
        double low = Rounding.ofSum(upper, lower, high);
        double product = high * HALF_PI_HIGH;
        double lost = Rounding.ofProduct(high, HALF_PI_HIGH, product);
        lost += high * HALF_PI_LOW + low * HALF_PI_HIGH;
        double x = product + lost;
        double unit = sign * Double.longBitsToDouble((long) (BIAS - 64 - zeros) << FRACTION_BITS);
        return Angle.quarter(quarters, unit * x, unit * Rounding.ofSum(product, lost, x));
    }
}
