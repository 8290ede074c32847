package rigibo.peers;

import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Shape;

/** The width of a shape across its motion through air. */
final class Width {

    private Width() {}

    /** The extent of a shape at an angle across a direction (x, y) other than 0, m. */
    static double across(Shape shape, double angle, double x, double y) {
        Outline outline = shape.outline(0);
        double length = Math.sqrt(x * x + y * y);
        double cos = Math.cos(angle);
        double sin = Math.sin(angle);
        // The direction, turned by a quarter, in the shape's own frame.
        double acrossX = (sin * x - cos * y) / length;
        double acrossY = (sin * y + cos * x) / length;
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < outline.corners(); i++) {
            double along = acrossX * outline.cornerX(i) + acrossY * outline.cornerY(i);
            least = Math.min(least, along);
            most = Math.max(most, along);
        }
        return most - least + 2 * outline.radius();
    }
}
