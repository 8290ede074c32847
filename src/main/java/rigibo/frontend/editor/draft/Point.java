package rigibo.frontend.editor.draft;

/**
 * A point, or a displacement.
 *
 * @param x m, to the right
 * @param y m, up
 */
public record Point(double x, double y) {

    /** The way to another place added. */
    public Point plus(Point way) {
        return new Point(x + way.x, y + way.y);
    }

    /** The way here from another place. */
    public Point minus(Point from) {
        return new Point(x - from.x, y - from.y);
    }

    /** A multiple of the way. */
    public Point times(double factor) {
        return new Point(x * factor, y * factor);
    }

    /** The way turned about the origin, degrees, counter-clockwise. */
    public Point turned(double degrees) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        return new Point(cos * x - sin * y, sin * x + cos * y);
    }

    /** Length of the way, m. */
    public double length() {
        return Math.hypot(x, y);
    }

    /** Direction of the way, degrees from the right, counter-clockwise. */
    public double direction() {
        return Math.toDegrees(Math.atan2(y, x));
    }

    /** Twice the area that this way and another span, m²; positive when the other lies left. */
    double cross(Point other) {
        return x * other.y - y * other.x;
    }
}
