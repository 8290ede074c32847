package rigibo.samples.box2d;

import rigibo.backend.Geometry;
import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** How far a shape gets on its way before it meets another. */
public final class ShapeCast implements Exhibit {
    private static final Shape MOVING = Polygon.box(0.8, 0.4);
    private static final Shape TARGET = Polygon.regular(5, 1);
    private double turn;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(TARGET).at(1.5, 0));
    }

    @Override
    public void beforeStep(Pool pool) {
        turn += 0.01;
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        Placement from = new Placement(-3, 1.6 * Angle.sin(turn), turn);
        double way = 6.5;
        double share = Geometry.cast(MOVING, from, way, 0, TARGET, Placement.at(1.5, 0)).orElse(1);
        sketch.shape(MOVING, from);
        sketch.shape(MOVING, new Placement(from.x() + share * way, from.y(), from.angle()));
        sketch.line(
                from.x(),
                from.y(),
                from.x() + share * way,
                from.y(),
                share < 1 ? Sketch.Tone.BAD : Sketch.Tone.GOOD);
    }

    @Override
    public View view() {
        return new View(0, 0, 9);
    }
}
