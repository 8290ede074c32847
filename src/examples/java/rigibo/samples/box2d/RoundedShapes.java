package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Polygons of three to eight corners with a rim of their own. */
public final class RoundedShapes implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.4, 6)).at(-3.8, 3));
        pool.add(BodyDefinition.fixed(Polygon.box(0.4, 6)).at(3.8, 3));
        for (int i = 0; i < 48; i++) {
            Polygon rounded = Polygon.regular(3 + i % 6, 0.3).rounded(0.04 + 0.04 * (i % 4));
            pool.add(
                    BodyDefinition.dynamic(rounded)
                            .at(-3 + 0.85 * (i % 8), 0.6 + 0.9 * (i / 8))
                            .angle(i));
        }
    }

    @Override
    public View view() {
        return new View(0, 3.2, 10);
    }
}
