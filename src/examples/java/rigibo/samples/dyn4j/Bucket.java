package rigibo.samples.dyn4j;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A bucket of three walls fills with boxes and balls. */
public final class Bucket implements Exhibit {
    @Override
    public void build(Pool pool) {

        pool.add(BodyDefinition.fixed(Polygon.box(7, 0.4)).at(0, 0));
        pool.add(BodyDefinition.fixed(Polygon.box(0.4, 6)).at(-3.6, 2.8));
        pool.add(BodyDefinition.fixed(Polygon.box(0.4, 6)).at(3.6, 2.8));
        Shape[] shapes = {
            new Circle(0.22),
            Polygon.box(0.4, 0.4),
            Polygon.regular(3, 0.3),
            Polygon.regular(5, 0.28)
        };
        for (int i = 0; i < 130; i++) {
            pool.add(
                    BodyDefinition.dynamic(shapes[i % 4])
                            .at(-2.9 + 0.58 * (i % 11), 0.6 + 0.6 * (i / 11))
                            .angle(i));
        }
    }

    @Override
    public View view() {
        return new View(0, 3.2, 10);
    }
}
