package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Marks the bodies that a wandering shape overlaps. */
public final class OverlapWorld implements Exhibit {
    private static final Shape LENS = Polygon.regular(6, 1.2);
    private double phase;

    @Override
    public void build(Pool pool) {

        for (int i = 0; i < 60; i++) {
            pool.add(
                    BodyDefinition.fixed(i % 2 == 0 ? new Circle(0.25) : Polygon.box(0.45, 0.45))
                            .at(-3.3 + 0.95 * (i % 8), -3.2 + 0.95 * (i / 8))
                            .angle(i));
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        phase += 0.01;
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        Placement at = new Placement(2 * Angle.sin(phase), 2 * Angle.cos(1.4 * phase), phase);
        sketch.shape(LENS, at);
        pool.overlapping(
                LENS, at, Filter.ALL, body -> sketch.point(body.x(), body.y(), Sketch.Tone.BAD));
    }

    @Override
    public View view() {
        return new View(0, 0, 11);
    }
}
