package rigibo.backend.force;

import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Shape;

/** The extent of a shape with all its parts along a direction; mutable, so that it is reused. */
final class Extent {

    /** Least and greatest coordinate along the direction, m. */
    double least;

    double most;

    /** Measures along a unit direction of the shape's own frame. */
    void measure(Shape shape, double x, double y) {
        least = Double.POSITIVE_INFINITY;
        most = Double.NEGATIVE_INFINITY;
        for (int part = 0; part < shape.parts(); part++) {
            Outline outline = shape.outline(part);
            for (int i = 0; i < outline.corners() && !shape.isSensor(part); i++) {
                double along = x * outline.cornerX(i) + y * outline.cornerY(i);
                least = Math.min(least, along - outline.radius());
                most = Math.max(most, along + outline.radius());
            }
        }
    }
}
