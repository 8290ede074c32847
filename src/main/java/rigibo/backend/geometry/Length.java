package rigibo.backend.geometry;

/**
 * Length of a vector with the same bits everywhere, without overflow on the way.
 *
 * <pre>{@code
 * double away = Length.hypot(3, 4); // 5 m
 * }</pre>
 */
public final class Length {

    /**
     * Components between these need no scaling before they are squared; their rounding errors are
     * normal doubles, too.
     */
    private static final double LARGEST = 0x1p500;

    private static final double LEAST = 0x1p-450;
    private static final double SCALE = 0x1p600;

    /** Share of the larger component below which the smaller one is lost in rounding. */
    private static final double NOTHING = 0x1p-60;

    private Length() {}

    /**
     * Returns √(x² + y²), within 0.75 units in the last place. It is infinite when a component is,
     * even if the other is NaN; otherwise it is NaN when a component is.
     */
    public static double hypot(double x, double y) {
        double large = Math.max(Math.abs(x), Math.abs(y));
        double small = Math.min(Math.abs(x), Math.abs(y));
        if (large < LARGEST && small > LEAST) {
            return plain(large, small);
        }
        if (Double.isInfinite(x) || Double.isInfinite(y)) {
            return Double.POSITIVE_INFINITY;
        }
        if (small <= NOTHING * large) {
            return large;
        }
        if (large >= LARGEST) {
            return SCALE * plain(large / SCALE, small / SCALE);
        }
        return small <= LEAST ? plain(large * SCALE, small * SCALE) / SCALE : Double.NaN;
    }

    /**
     * One step of Newton's method corrects the root by the rounding errors of the squares and of
     * their sum.
     */
    private static double plain(double large, double small) {
        double first = large * large;
        double second = small * small;
        double sum = first + second;
        double root = Math.sqrt(sum);
        double square = root * root;
        double lost = Rounding.ofSum(first, second, sum);
        lost += Rounding.ofProduct(large, large, first) + Rounding.ofProduct(small, small, second);
        double rest = sum - square - Rounding.ofProduct(root, root, square);
        // The processor can begin to divide by the sum before it knows the root.
        return root + (rest + lost) * (0.5 / sum) * root;
    }
}
