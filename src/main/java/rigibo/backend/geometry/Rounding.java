package rigibo.backend.geometry;

/**
 * The rounding error of a sum or a product of two doubles. The error is itself a double, unless it
 * is smaller than any normal one. A result and its error, kept together as a high and a low part,
 * have twice the digits.
 */
final class Rounding {

    /** 2²⁷ + 1: splits a double into two halves of 26 bits, whose products are exact. */
    private static final double SPLITTER = 0x1p27 + 1;

    private Rounding() {}

    /**
     * Returns a·b − product, exactly (T. J. Dekker, A Floating-Point Technique for Extending the
     * Available Precision, 1971). Written without {@code Math.fma}, which no browser has.
     *
     * @param a of a magnitude below 2⁹⁹⁰
     * @param product a·b, rounded
     */
    static double ofProduct(double a, double b, double product) {
        double scaledA = SPLITTER * a;
        double highA = scaledA - (scaledA - a);
        double lowA = a - highA;
        double scaledB = SPLITTER * b;
        double highB = scaledB - (scaledB - b);
        double lowB = b - highB;
        return lowA * lowB - (((product - highA * highB) - lowA * highB) - highA * lowB);
    }

    /** Returns large + small − sum, exactly, for |large| ≥ |small|. */
    static double ofSum(double large, double small, double sum) {
        return small - (sum - large);
    }
}
