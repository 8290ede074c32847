package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A body that slides beyond the edge tips over once its middle is past it. */
public final class Cliff implements Exhibit {
    @Override
    public void build(Pool pool) {

        pool.add(BodyDefinition.fixed(Polygon.box(8, 5)).at(-4, 2.5));
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(2, -0.5));
        Material smooth = new Material(1, 0.3, 0);
        pool.add(
                BodyDefinition.dynamic(Polygon.box(1, 1))
                        .at(-4.5, 5.5)
                        .velocity(4.4, 0)
                        .material(smooth));
        pool.add(
                BodyDefinition.dynamic(new Capsule(0.4, 0.25))
                        .at(-2.8, 5.25)
                        .velocity(3.6, 0)
                        .material(smooth));
        pool.add(
                BodyDefinition.dynamic(new Circle(0.4))
                        .at(-1.4, 5.4)
                        .velocity(1, 0)
                        .material(smooth));
    }

    @Override
    public View view() {
        return new View(0, 4, 12);
    }
}
