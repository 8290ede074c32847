package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A sheet of 1 cm falls at 80 m/s and stays above the floor. */
public final class SkinnyBox implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(
                BodyDefinition.dynamic(Polygon.box(2, 0.01))
                        .at(0, 5.5)
                        .angle(0.4)
                        .velocity(0, -80));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.02, 1.5)).at(2, 5).velocity(0, -80));
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}
