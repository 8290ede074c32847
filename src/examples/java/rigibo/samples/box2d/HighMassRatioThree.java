package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A rounded slab falls on two small discs. */
public final class HighMassRatioThree implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(-1, 0.2));
        pool.add(BodyDefinition.dynamic(new Circle(0.2)).at(1, 0.2));
        pool.add(
                BodyDefinition.dynamic(Polygon.box(4, 1.6).rounded(0.2))
                        .at(0, 4)
                        .material(new Material(16, 0.5, 0)));
    }

    @Override
    public View view() {
        return new View(0, 2.4, 9);
    }
}
