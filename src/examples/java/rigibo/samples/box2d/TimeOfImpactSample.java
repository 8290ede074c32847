package rigibo.samples.box2d;

import rigibo.backend.Geometry;
import rigibo.backend.Movement;
import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

import java.util.Locale;
import java.util.OptionalDouble;

/** A turning rod and a box: when they first touch within a second. */
public final class TimeOfImpactSample implements Exhibit {
    private static final Shape ROD = Polygon.box(3, 0.1);
    private static final Shape BOX = Polygon.box(1, 1);
    private static final Placement BOX_AT = Placement.at(2, 0);
    private double phase;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(BOX).at(2, 0));
    }

    @Override
    public void beforeStep(Pool pool) {
        phase += 0.01;
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        Placement from = new Placement(-3, Angle.sin(phase), 0);
        Movement way = new Movement(from, 6, 0, 9);
        OptionalDouble time =
                Geometry.timeOfImpact(ROD, way, BOX, new Movement(BOX_AT, 0, 0, 0), 1);
        double end = time.orElse(1);
        for (int i = 0; i <= 6; i++) {
            double t = end * i / 6;
            sketch.shape(ROD, new Placement(from.x() + 6 * t, from.y(), 9 * t));
        }
        sketch.count(time.isPresent() ? String.format(Locale.ROOT, "%.4f s", end) : "–");
    }

    @Override
    public View view() {
        return new View(0, 0, 10);
    }
}
