package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

import java.util.Locale;

/** A heavy block drops on a stack; the deepest overlap is shown. */
public final class SafetyFactor implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        for (int i = 0; i < 24; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.6, 0.6))
                            .at(-1.8 + 0.62 * (i % 6), 0.3 + 0.6 * (i / 6)));
        }
        pool.add(
                BodyDefinition.dynamic(Polygon.box(2.5, 1.5))
                        .at(-0.2, 9)
                        .material(new Material(20, 0.5, 0)));
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count(String.format(Locale.ROOT, "%.2f mm", 1000 * pool.report().deepestOverlap()));
    }

    @Override
    public View view() {
        return new View(0, 3.6, 11);
    }
}
