package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Discs stand on each other, each exactly over the one below. */
public final class CircleStack implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        for (int i = 0; i < 10; i++) {
            pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(0, 0.4 + 0.8 * i));
        }
    }

    @Override
    public View view() {
        return new View(0, 4, 11);
    }
}
