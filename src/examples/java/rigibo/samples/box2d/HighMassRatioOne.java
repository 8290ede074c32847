package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Light pyramids under one heavy box each. */
public final class HighMassRatioOne implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        for (int column = 0; column < 3; column++) {
            for (int row = 0; row < 6; row++) {
                for (int i = 0; i < 6 - row; i++) {
                    double x = 3 * (column - 1) + 0.42 * (i - (5 - row) / 2.0);
                    double density = row == 5 ? 60 * (column + 1) : 1;
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(0.4, 0.4))
                                    .at(x, 0.2 + 0.4 * row)
                                    .material(new Material(density, 0.5, 0)));
                }
            }
        }
    }

    @Override
    public View view() {
        return new View(0, 2.6, 9.5);
    }
}
