package rigibo.peers.dyn4j;

import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Rectangle;
import org.dyn4j.geometry.Vector2;

import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;

/** Our shapes as dyn4j's. */
final class Outlines {

    private Outlines() {}

    static Convex of(Shape shape) {
        return switch (shape.kind()) {
            case CIRCLE -> new org.dyn4j.geometry.Circle(((Circle) shape).radius());
            case CAPSULE -> capsule((Capsule) shape);
            case POLYGON -> polygon((Polygon) shape);
            case COMPOUND, CHAIN ->
                    throw new IllegalArgumentException("a peer is handed convex shapes only");
        };
    }

    private static Convex capsule(Capsule stated) {
        double width = 2 * stated.radius();
        return new org.dyn4j.geometry.Capsule(2 * stated.halfLength() + width, width);
    }

    private static Convex polygon(Polygon stated) {
        if (stated.isBox()) {
            return new Rectangle(2 * stated.cornerX(2), 2 * stated.cornerY(2));
        }
        Vector2[] corners = new Vector2[stated.corners()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = new Vector2(stated.cornerX(i), stated.cornerY(i));
        }
        return new org.dyn4j.geometry.Polygon(corners);
    }
}
