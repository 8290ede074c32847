package rigibo.peers.dyn4j;

import org.dyn4j.geometry.Capsule;
import org.dyn4j.geometry.Circle;
import org.dyn4j.geometry.Convex;
import org.dyn4j.geometry.Geometry;
import org.dyn4j.geometry.Polygon;
import org.dyn4j.geometry.Rectangle;
import org.dyn4j.geometry.Vector2;

import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Outline;
import rigibo.backend.geometry.Shape;
import rigibo.backend.geometry.ShapeKind;

import java.util.ArrayList;
import java.util.List;

/** Our shapes as dyn4j's, one or several. */
final class Outlines {

    private Outlines() {}

    static List<Convex> of(Shape shape) {
        List<Convex> pieces = new ArrayList<>();
        if (shape.kind() == ShapeKind.CHAIN) {
            pieces.addAll(links((Chain) shape));
        } else if (shape instanceof rigibo.backend.geometry.Polygon polygon && polygon.isBox()) {
            pieces.add(new Rectangle(2 * polygon.cornerX(2), 2 * polygon.cornerY(2)));
        } else {
            for (int part = 0; part < shape.parts(); part++) {
                pieces.add(of(shape.outline(part)));
            }
        }
        return pieces;
    }

    private static Convex of(Outline outline) {
        return switch (outline.corners()) {
            case 1 -> disc(outline);
            case 2 -> capsule(outline);
            default -> polygon(outline);
        };
    }

    private static Convex disc(Outline outline) {
        Circle disc = new Circle(outline.radius());
        disc.translate(outline.cornerX(0), outline.cornerY(0));
        return disc;
    }

    private static Convex capsule(Outline outline) {
        double alongX = outline.cornerX(1) - outline.cornerX(0);
        double alongY = outline.cornerY(1) - outline.cornerY(0);
        double width = 2 * outline.radius();
        Capsule capsule = new Capsule(Math.hypot(alongX, alongY) + width, width);
        capsule.rotate(Math.atan2(alongY, alongX), 0, 0);
        capsule.translate(
                (outline.cornerX(0) + outline.cornerX(1)) / 2,
                (outline.cornerY(0) + outline.cornerY(1)) / 2);
        return capsule;
    }

    private static Convex polygon(Outline outline) {
        if (outline.radius() > 0) {
            throw new UnsupportedOperationException("polygons with round corners");
        }
        Vector2[] corners = new Vector2[outline.corners()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = new Vector2(outline.cornerX(i), outline.cornerY(i));
        }
        return new Polygon(corners);
    }

    private static List<? extends Convex> links(Chain chain) {
        List<Vector2> corners = new ArrayList<>();
        for (int i = 0; i < chain.corners(); i++) {
            corners.add(new Vector2(chain.cornerX(i), chain.cornerY(i)));
        }
        return Geometry.createLinks(corners, chain.isLoop());
    }
}
