package rigibo.lab.plot;

/** A part of a picture, px. */
public record Box(double left, double top, double right, double bottom) {

    /**
     * Of a letter's size, what reaches above its baseline and below; accents and tails included.
     */
    private static final double ABOVE = 0.86;

    private static final double BELOW = 0.26;

    /** Around a place. */
    public static Box around(double x, double y, double radius) {
        return new Box(x - radius, y - radius, x + radius, y + radius);
    }

    /** What a text covers whose baseline is at y. */
    public static Box of(double x, double y, Anchor anchor, int size, String words) {
        double width = Letters.width(words, size);
        double left = anchor.left(x, width);
        return new Box(left, y - ABOVE * size, left + width, y + BELOW * size);
    }

    /** Whether two have more than an edge in common. */
    public boolean overlaps(Box other) {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }

    /** Whether all of another is within. */
    public boolean holds(Box other) {
        return left <= other.left
                && other.right <= right
                && top <= other.top
                && other.bottom <= bottom;
    }

    boolean holds(Spot spot) {
        return left <= spot.x() && spot.x() <= right && top <= spot.y() && spot.y() <= bottom;
    }
}
