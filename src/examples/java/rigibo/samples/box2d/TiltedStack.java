package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Each box stands a little aside of the one below. */
public final class TiltedStack implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(24, 1)).at(0, -0.5));
        Polygon box = Polygon.box(0.8, 0.8).rounded(0.05);
        for (int column = 0; column < 6; column++) {
            for (int row = 0; row < 8; row++) {
                pool.add(
                        BodyDefinition.dynamic(box)
                                .at(-5 + 1.9 * column + 0.14 * row, 0.45 + 0.9 * row));
            }
        }
    }

    @Override
    public View view() {
        return new View(0.4, 3.6, 13);
    }
}
