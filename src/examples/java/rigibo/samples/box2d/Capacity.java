package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** A box more every tenth of a second, until there are four hundred. */
public final class Capacity implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(60, 1)).at(0, -0.5));
        for (int i = 0; i < 40; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.4, 0.4))
                            .at(-2 + 0.45 * (i % 10), 0.2 + 0.42 * (i / 10)));
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        int count = pool.bodies().size();
        if (count < 400 && pool.time() >= 0.1 * (count - 40)) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.4, 0.4)).at(0.3 * (count * 7 % 5 - 2), 8));
        }
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count(String.valueOf(pool.bodies().size() - 1));
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}
