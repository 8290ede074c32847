package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Thin rods and boxes dropped from on high land on a thin floor. */
public final class ThinDrop implements Exhibit {
    @Override
    public void build(Pool pool) {

        pool.add(BodyDefinition.fixed(Polygon.box(10, 0.05)).at(0, 0));
        for (int i = 0; i < 12; i++) {
            pool.add(
                    BodyDefinition.dynamic(
                                    i % 2 == 0 ? Polygon.box(1, 0.05) : Polygon.box(0.4, 0.4))
                            .at(-3.2 + 0.6 * i, 3 + 0.4 * i)
                            .angle(0.5 * i)
                            .velocity(0, -30));
        }
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}
