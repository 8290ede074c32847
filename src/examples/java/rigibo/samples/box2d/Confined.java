package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A room without gravity as full of discs as it can be. */
public final class Confined implements Exhibit {
    @Override
    public void build(Pool pool) {

        for (int side = -1; side <= 1; side += 2) {
            pool.add(BodyDefinition.fixed(Polygon.box(8, 0.5)).at(0, side * 3.75));
            pool.add(BodyDefinition.fixed(Polygon.box(0.5, 8)).at(side * 3.75, 0));
        }
        for (int i = 0; i < 100; i++) {
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.34))
                            .at(-3.15 + 0.7 * (i % 10), -3.15 + 0.7 * (i / 10))
                            .velocity(i % 3 - 1, i % 5 - 2));
        }
    }

    @Override
    public Effects effects() {
        return Effects.usual().without(Gravity.class);
    }

    @Override
    public View view() {
        return new View(0, 0, 11);
    }
}
