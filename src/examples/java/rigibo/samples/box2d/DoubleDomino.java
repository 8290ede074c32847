package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A push runs through a row of dominoes and back through none. */
public final class DoubleDomino implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(24, 1)).at(0, -0.5));
        for (int i = 0; i < 15; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.2, 1))
                            .at(-4.2 + 0.6 * i, 0.5)
                            .material(new Material(1, 0.6, 0)));
        }
        pool.bodies().get(1).applyImpulse(0.2, 0, -4.2, 1);
    }

    @Override
    public View view() {
        return new View(0, 2, 11);
    }
}
