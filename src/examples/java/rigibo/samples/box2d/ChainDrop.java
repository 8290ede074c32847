package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A disc falls on a landscape of edges at 50 m/s. */
public final class ChainDrop implements Exhibit {
    @Override
    public void build(Pool pool) {

        pool.add(BodyDefinition.fixed(Chain.open(6, 1, 3, 0, 0, 0.4, -3, 0, -6, 1)));
        pool.add(
                BodyDefinition.dynamic(new Circle(0.4))
                        .at(-1, 8)
                        .velocity(0, -50)
                        .material(new Material(1, 0.5, 0.3)));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.7, 0.7)).at(1.5, 6).velocity(0, -50));
    }

    @Override
    public View view() {
        return new View(0, 2.4, 9);
    }
}
