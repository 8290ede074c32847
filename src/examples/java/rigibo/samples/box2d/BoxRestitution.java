package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Boxes of elasticity 0 to 1 that fall flat bounce flat. */
public final class BoxRestitution implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        for (int i = 0; i <= 10; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.45, 0.45))
                            .at(-3.5 + 0.7 * i, 5)
                            .material(new Material(1, 0.3, i / 10.0)));
        }
    }

    @Override
    public Effects effects() {
        return Effects.usual().without(Sleep.class);
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}
