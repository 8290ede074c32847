package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A hundred kilometres from the origin it stands as well. */
public final class FarPyramid implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(100_000, -0.5));
        for (int row = 0; row < 12; row++) {
            for (int i = 0; i < 12 - row; i++) {
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                                .at(100_000 + 0.55 * (i - (11 - row) / 2.0), 0.25 + 0.5 * row));
            }
        }
    }

    @Override
    public View view() {
        return new View(100_000, 3, 9);
    }
}
