package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A box that slides comes to rest where friction has used up its speed. */
public final class SingleBox implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(-2, 0.5).velocity(5, 0));
    }

    @Override
    public View view() {
        return new View(0, 2, 10);
    }
}
