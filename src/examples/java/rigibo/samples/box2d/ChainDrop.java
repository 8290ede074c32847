package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A disc falls on a landscape of edges at 50 m/s. */
public final class ChainDrop implements Exhibit {
    @Override
    public void build(Pool pool) {

        pool.add(
                BodyDefinition.fixed(
                        Chain.open(4, 7, 3.6, 0.8, 2.4, 0, 0, 0.4, -2.4, 0, -3.6, 0.8, -4, 7)));
        pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(-1, 5).velocity(0, -50));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.7, 0.7)).at(1.5, 4).velocity(0, -50));
    }

    @Override
    public View view() {
        return new View(0, 2.4, 9);
    }
}
