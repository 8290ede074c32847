package rigibo.samples.dyn4j;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Triangles, discs and boxes that spin as they fall. */
public final class TopsAndTriangles implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(16, 1)).at(0, -0.5));
        pool.add(
                BodyDefinition.dynamic(Polygon.of(0, 0.5, -0.5, -0.5, 0.5, -0.5))
                        .at(-1, 4)
                        .velocity(5, 0));
        pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(2, 4).velocity(-2, 0));
        pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 5).spin(2).velocity(-3, 0));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.5, 1.5)).at(0.5, 8).spin(-3));
    }

    @Override
    public View view() {
        return new View(0, 3.4, 10);
    }
}
