package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A heavy box flies into a block of small ones, without gravity. */
public final class Smash implements Exhibit {
    @Override
    public void build(Pool pool) {

        pool.add(
                BodyDefinition.dynamic(Polygon.box(2, 2))
                        .at(-7, 0)
                        .velocity(12, 0)
                        .material(new Material(8, 0.5, 0.1)));
        for (int i = 0; i < 320; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.3, 0.3))
                            .at(-1.5 + 0.31 * (i % 16), -3 + 0.31 * (i / 16)));
        }
    }

    @Override
    public Effects effects() {
        return Effects.usual().without(Gravity.class);
    }

    @Override
    public View view() {
        return new View(0, 0, 13);
    }
}
