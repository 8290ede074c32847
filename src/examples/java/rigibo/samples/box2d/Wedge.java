package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A ball shot into a narrow wedge comes to rest in it. */
public final class Wedge implements Exhibit {
    @Override
    public void build(Pool pool) {

        pool.add(BodyDefinition.fixed(Polygon.box(6, 0.3)).at(-0.85, 3).angle(-1.3));
        pool.add(BodyDefinition.fixed(Polygon.box(6, 0.3)).at(0.85, 3).angle(1.3));
        pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(0.2, 6).velocity(2, -60));
    }

    @Override
    public View view() {
        return new View(0, 3, 9);
    }
}
