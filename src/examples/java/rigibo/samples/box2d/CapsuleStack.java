package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Lying capsules touch along their whole length, as boxes do. */
public final class CapsuleStack implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        for (int i = 0; i < 9; i++) {
            pool.add(BodyDefinition.dynamic(new Capsule(0.8, 0.3)).at(0, 0.3 + 0.62 * i));
        }
    }

    @Override
    public View view() {
        return new View(0, 3, 9);
    }
}
