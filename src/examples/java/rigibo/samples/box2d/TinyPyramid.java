package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Boxes of 5 cm, which the engine stacks as well as boxes of 5 m. */
public final class TinyPyramid implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(3, 0.1)).at(0, -0.05));
        for (int row = 0; row < 14; row++) {
            for (int i = 0; i < 14 - row; i++) {
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.05, 0.05))
                                .at(0.055 * (i - (13 - row) / 2.0), 0.025 + 0.05 * row));
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 0.3, 1.1);
    }
}
