package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Thirty rays sweep over two hundred boxes. */
public final class CastField implements Exhibit {
    private double turn;

    @Override
    public void build(Pool pool) {

        for (int i = 0; i < 200; i++) {
            double x = 0.6 * (i % 14 - 6.5) + 0.13 * (i * 7 % 3);
            double y = 0.6 * (i / 14 - 7) + 0.11 * (i * 5 % 4);
            if (Math.abs(x) > 1 || Math.abs(y) > 1) {
                pool.add(BodyDefinition.fixed(Polygon.box(0.2, 0.2)).at(x, y).angle(i));
            }
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        turn += 0.004;
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        for (int i = 0; i < 30; i++) {
            double angle = turn + Math.PI * i / 15;
            double x = 6 * Angle.cos(angle);
            double y = 6 * Angle.sin(angle);
            pool.rayCast(0, 0, x, y)
                    .ifPresentOrElse(
                            hit -> {
                                sketch.line(0, 0, hit.x(), hit.y(), Sketch.Tone.GOOD);
                                sketch.point(hit.x(), hit.y(), Sketch.Tone.BAD);
                            },
                            () -> sketch.line(0, 0, x, y, Sketch.Tone.PLAIN));
        }
    }

    @Override
    public View view() {
        return new View(0, 0, 11);
    }
}
