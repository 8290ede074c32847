package rigibo.peers.gdx;

import com.badlogic.gdx.physics.box2d.CircleShape;
import com.badlogic.gdx.physics.box2d.PolygonShape;

import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.peers.Box2dFamily;

/** Our shapes as Box2D's, which whoever asked for them gives back. */
final class Outlines {

    private Outlines() {}

    static com.badlogic.gdx.physics.box2d.Shape of(Shape shape) {
        return switch (shape.kind()) {
            case CIRCLE -> disc((Circle) shape);
            case CAPSULE -> throw new IllegalArgumentException("Box2D knows no capsule");
            case POLYGON -> polygon((Polygon) shape);
            case COMPOUND, CHAIN ->
                    throw new IllegalArgumentException("a peer is handed convex shapes only");
        };
    }

    private static CircleShape disc(Circle circle) {
        CircleShape disc = new CircleShape();
        disc.setRadius((float) circle.radius());
        return disc;
    }

    private static PolygonShape polygon(Polygon stated) {
        PolygonShape polygon = new PolygonShape();
        if (stated.isBox()) {
            polygon.setAsBox((float) stated.cornerX(2), (float) stated.cornerY(2));
        } else {
            polygon.set(Box2dFamily.corners(stated));
        }
        return polygon;
    }
}
