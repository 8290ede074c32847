package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** The surface runs while the body stands still, so that it carries the bodies on it. */
public final class ConveyorBelt implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(24, 1)).at(0, -0.5));
        pool.add(
                BodyDefinition.fixed(Polygon.box(7, 0.4))
                        .at(-0.8, 3)
                        .material(new Material(1, 0.8, 0).surfaceSpeed(-2)));
        for (int i = 0; i < 8; i++) {
            pool.add(
                    BodyDefinition.dynamic(Polygon.box(0.6, 0.6))
                            .at(-3.8 + 0.1 * i, 3.6 + 0.9 * i));
        }
    }

    @Override
    public Effects effects() {
        return Effects.usual().with(new SurfaceSpeed());
    }

    @Override
    public View view() {
        return new View(0, 4, 12);
    }
}
