package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Columns of boxes stand; the right button shoots at them. */
public final class VerticalStack implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(24, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.4, 7)).at(5, 3.5));
        for (int column = 0; column < 4; column++) {
            for (int row = 0; row < 12; row++) {
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(0.5, 0.5))
                                .at(-1 + 1.3 * column, 0.25 + 0.5 * row));
            }
        }
    }

    /** From the left at the height of the pointer. */
    @Override
    public void act(Pool pool, double x, double y) {
        pool.add(
                BodyDefinition.dynamic(new Circle(0.25))
                        .at(-5, y)
                        .velocity(25, 0)
                        .material(new Material(4, 0.5, 0.2)));
    }

    @Override
    public View view() {
        return new View(0, 3.6, 12);
    }
}
