package rigibo.peers.jbox2d;

import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.peers.Box2dFamily;

/** Our shapes as JBox2D's. */
final class Outlines {

    private Outlines() {}

    static org.jbox2d.collision.shapes.Shape of(Shape shape) {
        return switch (shape.kind()) {
            case CIRCLE -> disc((Circle) shape);
            case CAPSULE -> throw new IllegalArgumentException("JBox2D knows no capsule");
            case POLYGON -> polygon((Polygon) shape);
            case COMPOUND, CHAIN ->
                    throw new IllegalArgumentException("a peer is handed convex shapes only");
        };
    }

    private static CircleShape disc(Circle circle) {
        CircleShape disc = new CircleShape();
        disc.m_radius = (float) circle.radius();
        return disc;
    }

    private static PolygonShape polygon(Polygon stated) {
        PolygonShape polygon = new PolygonShape();
        if (stated.isBox()) {
            polygon.setAsBox((float) stated.cornerX(2), (float) stated.cornerY(2));
            return polygon;
        }
        float[] xy = Box2dFamily.corners(stated);
        Vec2[] corners = new Vec2[stated.corners()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = new Vec2(xy[2 * i], xy[2 * i + 1]);
        }
        polygon.set(corners, corners.length);
        return polygon;
    }
}
