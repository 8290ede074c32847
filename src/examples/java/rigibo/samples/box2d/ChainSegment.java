package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** From above it lands, from below it passes. */
public final class ChainSegment implements Exhibit {
    @Override
    public void build(Pool pool) {

        pool.add(BodyDefinition.fixed(Polygon.box(12, 0.5)).at(0, -0.25));
        pool.add(BodyDefinition.fixed(Chain.open(3, 2.5, -3, 2.5)));
        pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(-1.5, 6));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.6, 0.6)).at(1.5, 0.4).velocity(0, 9));
    }

    @Override
    public View view() {
        return new View(0, 2.6, 9);
    }
}
