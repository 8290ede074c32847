package rigibo.samples.dyn4j;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Sixteen rows of boxes stand. */
public final class PyramidOfCrates implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        for (int row = 0; row < 16; row++) {
            for (int i = 0; i < 16 - row; i++) {
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.42, 0.42))
                                .at(0.45 * (i - (15 - row) / 2.0), 0.21 + 0.42 * row));
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 3.4, 10);
    }
}
