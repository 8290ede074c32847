package rigibo.samples.dyn4j;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Balls thrown up pass the platforms from below and land on them. */
public final class OneWayPlatforms implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        Material wood = Material.DEFAULT.oneWay(0, 1);
        for (int i = 0; i < 3; i++) {
            pool.add(
                    BodyDefinition.fixed(Polygon.box(2, 0.2))
                            .at(-2.6 + 2.6 * i, 1.6 + 1.4 * i)
                            .material(wood));
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.3))
                            .at(-2.6 + 2.6 * i, 0.3)
                            .velocity(0, 7.5 + 1.6 * i));
            pool.add(
                    BodyDefinition.dynamic(new Capsule(0.3, 0.2))
                            .at(-3 + 2.6 * i, 3.4 + 1.4 * i)
                            .angle(Math.PI / 2));
        }
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}
