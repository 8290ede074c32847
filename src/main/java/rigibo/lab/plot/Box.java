package rigibo.lab.plot;

/** A rectangle in a picture, px. */
public record Box(double left, double top, double right, double bottom) {

    /** Heights above and below the baseline, in letter sizes, accents and tails included. */
    private static final double ABOVE = 0.86;

    private static final double BELOW = 0.26;

    /** A box around a spot. */
    public static Box around(double x, double y, double radius) {
        return new Box(x - radius, y - radius, x + radius, y + radius);
    }

    /** The box of a text whose baseline is at y. */
    public static Box of(double x, double y, Anchor anchor, int size, String words) {
        double width = Letters.width(words, size);
        double left = anchor.left(x, width);
        return new Box(left, y - ABOVE * size, left + width, y + BELOW * size);
    }

    /** Whether two boxes overlap by more than an edge. */
    public boolean overlaps(Box other) {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }

    /** Whether it contains another box. */
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
