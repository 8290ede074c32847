package rigibo.backend.geometry;

import java.math.BigDecimal;
import java.math.BigInteger;

/**
 * Elementary functions in whole numbers, a unit of which is 2⁻³²⁰, and what doubles that claim to
 * be their values are off by. An inverse function is judged by the function that it inverts.
 */
final class Truth {

    private static final int BITS = 320;
    private static final BigInteger ONE = BigInteger.ONE.shiftLeft(BITS);

    /** Of the largest double as many digits of π are asked. */
    private static final int MORE_BITS = BITS + 1100;

    private static final BigInteger PI =
            arcTangentOfOneOver(5)
                    .shiftLeft(2)
                    .subtract(arcTangentOfOneOver(239))
                    .shiftLeft(2)
                    .shiftRight(64);

    private static final BigInteger LN_2 = lnTwo();

    private Truth() {}

    /** How far a double is from a truth, in units in the last place of the truth. */
    private static double off(double value, BigInteger truth) {
        return inUnits(exact(value).subtract(truth), truth);
    }

    private static double inUnits(BigInteger off, BigInteger truth) {
        double size = Math.ulp(asDouble(truth.abs()));
        return asDouble(off.abs()) / size;
    }

    private static double asDouble(BigInteger fixed) {
        int less = Math.max(0, fixed.bitLength() - 62);
        return Math.scalb((double) fixed.shiftRight(less).longValue(), less - BITS);
    }

    /** Rounded to a unit where the double is finer. */
    private static BigInteger exact(double value) {
        int exponent = Math.max(Math.getExponent(value), Double.MIN_EXPONENT) - 52;
        long whole = (long) Math.scalb(value, -exponent);
        return BigInteger.valueOf(whole).shiftLeft(BITS + exponent);
    }

    static double offSine(double angle, double value) {
        return off(value, sine(angle, 0));
    }

    static double offCosine(double angle, double value) {
        return off(value, sine(angle, 1));
    }

    /** The angle that is left to the direction (x, y), whose tangent is so small that it is it. */
    static double offAngle(double y, double x, double value) {
        double scale = Math.scalb(1.0, -Math.getExponent(Math.max(Math.abs(y), Math.abs(x))));
        return offAngle(exact(y * scale), exact(x * scale), value);
    }

    private static double offAngle(BigInteger y, BigInteger x, double value) {
        BigInteger sine = sine(value, 0);
        BigInteger cosine = sine(value, 1);
        BigInteger across = y.multiply(cosine).subtract(x.multiply(sine));
        BigInteger along = x.multiply(cosine).add(y.multiply(sine));
        return inUnits(across.shiftLeft(BITS).divide(along), exact(value));
    }

    static double offAngleOfSine(double sine, double value) {
        return offAngle(exact(sine), beside(sine), value);
    }

    static double offAngleOfCosine(double cosine, double value) {
        return offAngle(beside(cosine), exact(cosine), value);
    }

    private static BigInteger beside(double sine) {
        BigInteger exact = exact(sine);
        return ONE.multiply(ONE).subtract(exact.multiply(exact)).sqrt();
    }

    static double offLength(double y, double x, double value) {
        BigDecimal sum = new BigDecimal(x).pow(2).add(new BigDecimal(y).pow(2));
        BigDecimal lack = new BigDecimal(value).pow(2).subtract(sum);
        double unit = Math.ulp(value);
        BigDecimal slope = new BigDecimal(value).multiply(new BigDecimal(2 * unit));
        return Math.abs(lack.divide(slope, 20, java.math.RoundingMode.HALF_UP).doubleValue());
    }

    static double offPowerOfE(double x, double value) {
        return offPower(exact(x), value);
    }

    /** How far a double is from e to a power; subnormal ones and huge ones, too. */
    private static double offPower(BigInteger power, double value) {
        BigInteger turns = power.divide(LN_2);
        BigInteger truth = powerOfE(power.subtract(turns.multiply(LN_2)));
        int exponent = turns.intValue();
        int unit = Math.max(exponent + truth.bitLength() - 1 - BITS, Double.MIN_EXPONENT) - 52;
        BigInteger whole =
                new BigDecimal(value).multiply(powerOfTwo(BITS - exponent)).toBigInteger();
        return asDouble(whole.subtract(truth).abs()) / Math.scalb(1.0, unit - exponent);
    }

    private static BigDecimal powerOfTwo(int power) {
        BigDecimal size = new BigDecimal(BigInteger.ONE.shiftLeft(Math.abs(power)));
        return power < 0 ? BigDecimal.ONE.divide(size) : size;
    }

    static double offPowerOfELessOne(double x, double value) {
        return off(value, powerOfE(exact(x)).subtract(ONE));
    }

    static double offHyperbolicTangent(double x, double value) {
        BigInteger power = powerOfE(exact(2 * x));
        return off(value, power.subtract(ONE).shiftLeft(BITS).divide(power.add(ONE)));
    }

    static double offLogarithm(double x, double value) {
        return off(value, logarithm(x));
    }

    static double offPower(double x, double y, double value) {
        return offPower(product(exact(y), logarithm(x)), value);
    }

    /** The logarithm of the JVM, and that of what it lacks. */
    private static BigInteger logarithm(double x) {
        int exponent = Math.getExponent(x);
        double part = Math.scalb(x, -exponent);
        BigInteger near = exact(StrictMath.log(part));
        BigInteger ratio = exact(part).shiftLeft(BITS).divide(powerOfE(near)).subtract(ONE);
        BigInteger term = ratio;
        BigInteger sum = near.add(LN_2.multiply(BigInteger.valueOf(exponent)));
        for (int i = 1; term.signum() != 0; i++) {
            BigInteger part2 = term.divide(BigInteger.valueOf(i));
            sum = (i & 1) == 1 ? sum.add(part2) : sum.subtract(part2);
            term = product(term, ratio);
        }
        return sum;
    }

    private static BigInteger product(BigInteger a, BigInteger b) {
        return a.multiply(b).shiftRight(BITS);
    }

    /** Sine of an angle and some quarter turns. */
    private static BigInteger sine(double angle, int more) {
        int exponent = Math.max(Math.getExponent(angle), Double.MIN_EXPONENT) - 52;
        BigInteger whole = BigInteger.valueOf((long) Math.scalb(angle, -exponent));
        BigInteger half = PI.shiftRight(1);
        BigInteger[] turns = whole.shiftLeft(MORE_BITS + exponent).divideAndRemainder(half);
        int quarters = turns[0].mod(BigInteger.valueOf(4)).intValue() + more & 3;
        BigInteger x = turns[1].shiftRight(MORE_BITS - BITS);
        BigInteger value = (quarters & 1) == 0 ? series(x, x, 2) : series(x, ONE, 1);
        return (quarters & 2) == 0 ? value : value.negate();
    }

    /** first·(1 − x²/(k(k + 1)) + …). */
    private static BigInteger series(BigInteger x, BigInteger first, int k) {
        BigInteger square = product(x, x);
        BigInteger term = first;
        BigInteger sum = BigInteger.ZERO;
        for (int i = k; term.signum() != 0; i += 2) {
            sum = sum.add(term);
            term = product(term, square).divide(BigInteger.valueOf(-(long) i * (i + 1)));
            if (term.equals(BigInteger.ONE.negate())) {
                term = BigInteger.ZERO;
            }
        }
        return sum;
    }

    private static BigInteger powerOfE(BigInteger x) {
        BigInteger turns = x.divide(LN_2);
        BigInteger rest = x.subtract(turns.multiply(LN_2));
        BigInteger term = ONE;
        BigInteger sum = BigInteger.ZERO;
        for (int i = 1; term.abs().compareTo(BigInteger.ONE) > 0; i++) {
            sum = sum.add(term);
            term = product(term, rest).divide(BigInteger.valueOf(i));
        }
        return sum.shiftLeft(turns.intValue());
    }

    /** With 64 digits more than are asked. */
    private static BigInteger arcTangentOfOneOver(int n) {
        BigInteger term = BigInteger.ONE.shiftLeft(MORE_BITS + 64).divide(BigInteger.valueOf(n));
        BigInteger square = BigInteger.valueOf(-(long) n * n);
        BigInteger sum = BigInteger.ZERO;
        for (int i = 1; term.signum() != 0; i += 2) {
            sum = sum.add(term.divide(BigInteger.valueOf(i)));
            term = term.divide(square);
        }
        return sum;
    }

    /** Σ 1/(k·2ᵏ). */
    private static BigInteger lnTwo() {
        BigInteger sum = BigInteger.ZERO;
        for (int k = 1; k < BITS + 64; k++) {
            sum =
                    sum.add(
                            ONE.shiftLeft(64 - k > 0 ? 64 - k : 0)
                                    .shiftRight(k > 64 ? k - 64 : 0)
                                    .divide(BigInteger.valueOf(k)));
        }
        return sum.shiftRight(64);
    }
}
