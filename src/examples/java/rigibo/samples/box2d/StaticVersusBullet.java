package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A block that hardly turns stops a bullet of 300 m/s. */
public final class StaticVersusBullet implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(
                BodyDefinition.dynamic(Polygon.box(0.4, 3))
                        .at(1, 1.5)
                        .lockRotation()
                        .material(new Material(20, 0.5, 0)));
        pool.add(
                BodyDefinition.dynamic(new Circle(0.05))
                        .at(-60, 2)
                        .velocity(300, 0)
                        .gravityScale(0)
                        .material(new Material(50, 0.1, 0.3)));
    }

    @Override
    public View view() {
        return new View(0, 2, 9);
    }
}
