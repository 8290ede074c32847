package rigibo.samples.dyn4j;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Us and plus signs, each one body of convex parts. */
public final class ConcaveShapes implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(16, 1)).at(0, -0.5));
        Compound cup =
                Compound.ofOutline(
                        0, 0, 1.2, 0, 1.2, 0.9, 0.95, 0.9, 0.95, 0.25, 0.25, 0.25, 0.25, 0.9, 0,
                        0.9);
        for (int i = 0; i < 9; i++) {
            pool.add(
                    BodyDefinition.dynamic(cup)
                            .at(-2.6 + 2.6 * (i % 3), 1 + 1.8 * (i / 3))
                            .angle(0.7 * i));
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.25))
                            .at(-2.6 + 2.6 * (i % 3), 1.8 + 1.8 * (i / 3)));
        }
    }

    @Override
    public View view() {
        return new View(0, 3.2, 10);
    }
}
