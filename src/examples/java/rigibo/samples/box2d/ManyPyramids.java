package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Six pyramids on three shelves. */
public final class ManyPyramids implements Exhibit {
    @Override
    public void build(Pool pool) {

        for (int shelf = 0; shelf < 6; shelf++) {
            double x = shelf % 2 == 0 ? -2.4 : 2.4;
            double y = 2.8 * (shelf / 2);
            pool.add(BodyDefinition.fixed(Polygon.box(4.4, 0.2)).at(x, y - 0.1));
            for (int row = 0; row < 8; row++) {
                for (int i = 0; i < 8 - row; i++) {
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(0.28, 0.28))
                                    .at(x + 0.32 * (i - (7 - row) / 2.0), y + 0.14 + 0.28 * row));
                }
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}
