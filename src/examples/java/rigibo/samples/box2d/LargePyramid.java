package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Three hundred boxes stand still. */
public final class LargePyramid implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(24, 1)).at(0, -0.5));
        for (int row = 0; row < 24; row++) {
            for (int i = 0; i < 24 - row; i++) {
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.35, 0.35))
                                .at(0.38 * (i - (23 - row) / 2.0), 0.175 + 0.35 * row));
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}
