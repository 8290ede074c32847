package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Balls on lanes: the longer the lever, the sooner they stop. */
public final class RollingShapes implements Exhibit {
    @Override
    public void build(Pool pool) {

        for (int i = 0; i < 7; i++) {
            pool.add(BodyDefinition.fixed(Polygon.box(8, 0.2)).at(0, 1.2 * i));
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.35))
                            .at(-3.5, 1.2 * i + 0.45)
                            .velocity(2.5, 0)
                            .spin(-2.5 / 0.35)
                            .material(new Material(1, 0.6, 0).rollingResistance(0.01 * i)));
        }
    }

    @Override
    public Effects effects() {
        return Effects.usual().with(new RollingResistance());
    }

    @Override
    public View view() {
        return new View(0, 3.8, 11);
    }
}
