package rigibo.peers.gdx;

import com.badlogic.gdx.math.Vector2;
import com.badlogic.gdx.physics.box2d.ChainShape;
import com.badlogic.gdx.physics.box2d.CircleShape;
import com.badlogic.gdx.physics.box2d.PolygonShape;

import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;
import rigibo.peers.Box2dFamily;

import java.util.ArrayList;
import java.util.List;

/** Our shapes as Box2D's, one or several; the caller disposes of them. */
final class Outlines {

    private Outlines() {}

    static List<com.badlogic.gdx.physics.box2d.Shape> of(Shape shape) {
        List<com.badlogic.gdx.physics.box2d.Shape> pieces = new ArrayList<>();
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

    /** Adds a shape; Box2D has no capsule, so a box and a disc at either end replace it. */
    private static void add(Outline outline, List<com.badlogic.gdx.physics.box2d.Shape> pieces) {
        if (outline.corners() > 2) {
            PolygonShape polygon = new PolygonShape();
            polygon.set(Box2dFamily.corners(outline));
            pieces.add(polygon);
            return;
        }
        if (outline.corners() == 2) {
            PolygonShape middle = new PolygonShape();
            middle.set(Box2dFamily.between(outline));
            pieces.add(middle);
        }
        for (int end = 0; end < outline.corners(); end++) {
            CircleShape disc = new CircleShape();
            disc.setRadius((float) outline.radius());
            disc.setPosition(
                    new Vector2((float) outline.cornerX(end), (float) outline.cornerY(end)));
            pieces.add(disc);
        }
    }

    private static ChainShape chain(Chain stated) {
        ChainShape chain = new ChainShape();
        float[] xy = Box2dFamily.corners(stated);
        if (stated.isLoop()) {
            chain.createLoop(xy);
        } else {
            chain.createChain(xy);
        }
        return chain;
    }
}
