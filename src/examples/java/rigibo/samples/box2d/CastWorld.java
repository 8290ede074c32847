package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RayHit;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Placement;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Filter;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** A ray, a disc and a capsule are cast through a world of shapes. */
public final class CastWorld implements Exhibit {
    private double phase;

    @Override
    public void build(Pool pool) {

        Shape[] shapes = {
            new Circle(0.3), new Capsule(0.3, 0.2), Polygon.box(0.6, 0.6), Polygon.regular(3, 0.5)
        };
        for (int i = 0; i < 24; i++) {
            pool.add(
                    BodyDefinition.fixed(shapes[i % 4])
                            .at(-2 + 1.2 * (i % 5) + 0.2 * (i % 3), -3.4 + 1.4 * (i / 5))
                            .angle(i));
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        phase += 0.008;
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        double y = 3.2 * Angle.sin(phase);
        pool.rayCast(-4.2, y, 4.2, y)
                .ifPresentOrElse(
                        hit -> {
                            sketch.line(-4.2, y, hit.x(), hit.y(), Sketch.Tone.GOOD);
                            sketch.point(hit.x(), hit.y(), Sketch.Tone.BAD);
                        },
                        () -> sketch.line(-4.2, y, 4.2, y, Sketch.Tone.PLAIN));
        cast(pool, new Circle(0.25), y + 1, sketch);
        cast(pool, new Capsule(0.25, 0.15), y - 1, sketch);
    }

    private static void cast(Pool pool, Shape shape, double y, Sketch sketch) {
        Placement from = new Placement(-4.2, y, 1);
        double share = pool.cast(shape, from, 8.4, 0, Filter.ALL).map(RayHit::fraction).orElse(1.0);
        sketch.line(-4.2, y, -4.2 + 8.4 * share, y, Sketch.Tone.PLAIN);
        sketch.shape(shape, new Placement(-4.2 + 8.4 * share, y, 1));
    }

    @Override
    public View view() {
        return new View(0, 0, 11);
    }
}
