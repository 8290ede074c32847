package rigibo.peers.jbox2d;

import org.jbox2d.collision.shapes.ChainShape;
import org.jbox2d.collision.shapes.CircleShape;
import org.jbox2d.collision.shapes.PolygonShape;
import org.jbox2d.common.Vec2;

import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;
import rigibo.peers.Box2dFamily;

import java.util.ArrayList;
import java.util.List;

/** Our shapes as JBox2D's, one or several. */
final class Outlines {

    private Outlines() {}

    static List<org.jbox2d.collision.shapes.Shape> of(Shape shape) {
        List<org.jbox2d.collision.shapes.Shape> pieces = new ArrayList<>();
        if (shape.kind() == ShapeKind.CHAIN) {
            pieces.add(chain((Chain) shape));
        } else if (shape instanceof Polygon polygon && polygon.isBox()) {
            PolygonShape box = new PolygonShape();
            box.setAsBox((float) polygon.cornerX(2), (float) polygon.cornerY(2));
            pieces.add(box);
        } else {
            for (int part = 0; part < shape.parts(); part++) {
                add(shape.outline(part), pieces);
            }
        }
        return pieces;
    }

    /** Adds a shape; JBox2D has no capsule, so a box and a disc at either end replace it. */
    private static void add(Outline outline, List<org.jbox2d.collision.shapes.Shape> pieces) {
        if (outline.corners() > 2) {
            pieces.add(polygon(Box2dFamily.corners(outline)));
            return;
        }
        if (outline.corners() == 2) {
            pieces.add(polygon(Box2dFamily.between(outline)));
        }
        for (int end = 0; end < outline.corners(); end++) {
            CircleShape disc = new CircleShape();
            disc.m_radius = (float) outline.radius();
            disc.m_p.set((float) outline.cornerX(end), (float) outline.cornerY(end));
            pieces.add(disc);
        }
    }

    private static PolygonShape polygon(float[] xy) {
        PolygonShape polygon = new PolygonShape();
        polygon.set(points(xy), xy.length / 2);
        return polygon;
    }

    private static ChainShape chain(Chain stated) {
        ChainShape chain = new ChainShape();
        Vec2[] corners = points(Box2dFamily.corners(stated));
        if (stated.isLoop()) {
            chain.createLoop(corners, corners.length);
        } else {
            chain.createChain(corners, corners.length);
        }
        return chain;
    }

    private static Vec2[] points(float[] xy) {
        Vec2[] points = new Vec2[xy.length / 2];
        for (int i = 0; i < points.length; i++) {
            points[i] = new Vec2(xy[2 * i], xy[2 * i + 1]);
        }
        return points;
    }
}
