package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Boxes of less and less friction on a slope. */
public final class FrictionShapes implements Exhibit {
    @Override
    public void build(Pool pool) {

        for (int i = 0; i < 5; i++) {
            double y = 6.6 - 1.6 * i;
            pool.add(
                    BodyDefinition.fixed(Polygon.box(7, 0.15))
                            .at(0, y)
                            .angle(-0.25)
                            .material(new Material(1, 0.6, 0)));
            double friction = new double[] {0.5, 0.2, 0.1, 0.05, 0}[i];
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.6, 0.6))
                            .at(-2.8 + 0.375 * 0.25, y + 0.71 + 0.375)
                            .angle(-0.25)
                            .material(new Material(1, friction, 0)));
        }
    }

    @Override
    public View view() {
        return new View(0, 3.6, 11);
    }
}
