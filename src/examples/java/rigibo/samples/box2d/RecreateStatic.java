package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Each step the floor is taken away and another laid. */
public final class RecreateStatic implements Exhibit {
    private RigidBody floor;

    @Override
    public void build(Pool pool) {

        floor = pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.5));
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 2).velocity(2, 0));
    }

    @Override
    public void beforeStep(Pool pool) {
        pool.remove(floor);
        floor = pool.add(BodyDefinition.fixed(Polygon.box(12, 1)).at(0, -0.5));
    }

    @Override
    public View view() {
        return new View(0, 2, 9);
    }
}
