package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Thrown so that its foot stands still at first. */
public final class Pivot implements Exhibit {
    @Override
    public void build(Pool pool) {

        double spin = 3;
        pool.add(
                BodyDefinition.dynamic(Polygon.box(0.2, 2))
                        .at(0, 1)
                        .velocity(-spin, 0)
                        .spin(spin)
                        .gravityScale(0));
        pool.add(
                BodyDefinition.dynamic(Polygon.box(0.2, 2)).at(2, 1).velocity(-spin, 0).spin(spin));
    }

    @Override
    public View view() {
        return new View(0, 2, 10);
    }
}
