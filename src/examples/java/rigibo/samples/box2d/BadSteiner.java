package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A thin triangle far from round keeps its inertia and rests. */
public final class BadSteiner implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        Polygon sliver = Polygon.of(0, 0, 3, 0.02, 1.2, 0.3);
        pool.add(BodyDefinition.dynamic(sliver).at(0, 2).angle(0.5));
    }

    @Override
    public View view() {
        return new View(0, 1.6, 6);
    }
}
