package rigibo.frontend.gallery;

/**
 * The part of the world that a window shows.
 *
 * @param x of its middle, m
 * @param y of its middle, m
 * @param height from its lower to its upper edge, m
 */
public record View(double x, double y, double height) {

    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException naming the one that is not finite, or not positive
     */
    public View {
        if (!(Math.abs(x) + Math.abs(y) < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "View.x and y must be finite (m), were (" + x + ", " + y + ")");
        }
        if (!(height > 0 && height < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "View.height must be positive and finite (m), was " + height);
        }
    }
}
