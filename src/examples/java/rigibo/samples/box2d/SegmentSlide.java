package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A ball thrown flat at 40 m/s over butted slabs does not trip. */
public final class SegmentSlide implements Exhibit {
    @Override
    public void build(Pool pool) {

        for (int i = 0; i < 60; i++) {
            pool.add(BodyDefinition.fixed(Polygon.box(0.5, 0.5)).at(-15 + 0.5 * i, -0.25));
        }
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 4)).at(4.4, 2));
        pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(-14, 0.4).velocity(40, 0));
    }

    @Override
    public View view() {
        return new View(0, 2, 11);
    }
}
