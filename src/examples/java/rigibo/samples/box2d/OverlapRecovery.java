package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Boxes made one inside the other part without flying apart. */
public final class OverlapRecovery implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        for (int row = 0; row < 5; row++) {
            for (int i = 0; i < 5 - row; i++) {
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.8, 0.8))
                                .at(0.6 * (i - (4 - row) / 2.0), 0.3 + 0.6 * row));
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 2, 7);
    }
}
