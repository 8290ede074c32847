package rigibo.samples.dyn4j;

import rigibo.backend.Pool;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Bodies with skins in syrup: damping of 0.05 a second. */
public final class ManyImages implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(16, 1)).at(0, -0.5));
        Material damped = new Material(1, 0.5, 0.3).drag(0.05);
        for (int i = 0; i < 18; i++) {
            Shape shape = i % 2 == 0 ? new Circle(0.4) : Polygon.box(0.7, 0.7);
            pool.add(
                    BodyDefinition.dynamic(shape)
                            .at(-3 + 1.2 * (i % 6), 1 + 1.2 * (i / 6))
                            .material(damped));
        }
    }

    @Override
    public Effects effects() {
        return Effects.usual().with(new Drag());
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}
