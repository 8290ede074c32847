package rigibo.frontend.editor.draft;

/**
 * A point, or a displacement.
 *
 * @param x m, to the right
 * @param y m, up
 */
public record Point(double x, double y) {

    /** Sum of this displacement and another one. */
    public Point plus(Point way) {
        return new Point(x + way.x, y + way.y);
    }

    /** Displacement from another point to this one. */
    public Point minus(Point from) {
        return new Point(x - from.x, y - from.y);
    }

    /** Multiple of this displacement. */
    public Point times(double factor) {
        return new Point(x * factor, y * factor);
    }

    /** This displacement turned about the origin, degrees, counter-clockwise. */
    public Point turned(double degrees) {
        double cos = Math.cos(Math.toRadians(degrees));
        double sin = Math.sin(Math.toRadians(degrees));
        return new Point(cos * x - sin * y, sin * x + cos * y);
    }

    /** Length of this displacement, m. */
    public double length() {
        return Math.hypot(x, y);
    }

    /** Direction of this displacement, degrees from the right, counter-clockwise. */
    public double direction() {
        return Math.toDegrees(Math.atan2(y, x));
    }

    /** Whether this point is within a distance of the line from one point to another, m. */
    public boolean isNear(Point from, Point to, double distance) {
        Point way = to.minus(from);
        Point there = minus(from);
        double square = way.x * way.x + way.y * way.y;
        double along = there.x * way.x + there.y * way.y;
        double share = square > 0 ? Math.max(0, Math.min(1, along / square)) : 0;
        return there.minus(way.times(share)).length() <= distance;
    }

    /**
     * Cross product of this displacement and another one, m²; positive if the other one lies to the
     * left.
     */
    double cross(Point other) {
        return x * other.y - y * other.x;
    }
}
