package rigibo.samples.box2d;

import rigibo.backend.Geometry;
import rigibo.backend.Pool;
import rigibo.backend.ShapeContact;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Where shapes touch, with the normal and how deep they overlap. */
public final class ManifoldSample implements Exhibit {
    private static final Shape[] SHAPES = {
        Polygon.box(1.2, 1.2),
        new Circle(0.6),
        new Capsule(0.5, 0.3),
        Polygon.regular(3, 0.8),
        Polygon.box(0.9, 0.9).rounded(0.15)
    };
    private double turn;

    @Override
    public void build(Pool pool) {}

    @Override
    public void beforeStep(Pool pool) {
        turn += 0.01;
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        for (int i = 0; i < SHAPES.length * SHAPES.length; i++) {
            double x = 1.8 * (i % SHAPES.length - 2);
            double y = 1.8 * (i / SHAPES.length - 2);
            Placement lower = new Placement(x, y - 0.4, turn);
            Placement upper = new Placement(x + 0.1 * Angle.sin(3 * turn), y + 0.5, -turn);
            draw(SHAPES[i % SHAPES.length], lower, SHAPES[i / SHAPES.length], upper, sketch);
        }
    }

    private static void draw(
            Shape one, Placement at, Shape other, Placement otherAt, Sketch sketch) {
        sketch.shape(one, at);
        sketch.shape(other, otherAt);
        for (ShapeContact contact : Geometry.contacts(one, at, other, otherAt, 0.1)) {
            for (ShapeContact.Point point : contact.points()) {
                sketch.point(
                        point.x(), point.y(), point.gap() > 0 ? Sketch.Tone.GOOD : Sketch.Tone.BAD);
                sketch.line(
                        point.x(),
                        point.y(),
                        point.x() + 0.4 * contact.normalX(),
                        point.y() + 0.4 * contact.normalY(),
                        Sketch.Tone.PLAIN);
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 0, 12);
    }
}
