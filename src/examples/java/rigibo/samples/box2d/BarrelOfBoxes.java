package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A barrel full of boxes. */
public final class BarrelOfBoxes implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 8)).at(-4.25, 4));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 8)).at(4.25, 4));
        for (int i = 0; i < 140; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                            .at(-3.5 + 0.7 * (i % 11), 0.4 + 0.62 * (i / 11)));
        }
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}
