package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** Boxes locked in x, in y, in turning, in two of them and in nothing, under a hail of discs. */
public final class MixedLocks implements Exhibit {
    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.4, 12)).at(-5.2, 5.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.4, 12)).at(5.2, 5.5));
        BodyDefinition box =
                BodyDefinition.dynamic(Polygon.box(0.9, 0.9)).material(new Material(8, 0.5, 0.2));
        BodyDefinition[] locked = {
            box,
            box.lockX(),
            box.lockY(),
            box.lockRotation(),
            box.lockX().lockRotation(),
            box.lockY().lockRotation()
        };
        for (int i = 0; i < locked.length; i++) {
            pool.add(locked[i].at(-3.75 + 1.5 * i, 2));
        }
        for (int i = 0; i < 24; i++) {
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.25))
                            .at(-4.3 + 0.37 * i, 5 + 0.6 * (i % 5))
                            .material(new Material(5, 0.3, 0.4)));
        }
    }

    @Override
    public void act(Pool pool, double x, double y) {
        pool.add(
                BodyDefinition.dynamic(new Circle(0.35))
                        .at(x, y)
                        .material(new Material(5, 0.3, 0.4)));
    }

    @Override
    public View view() {
        return new View(0, 3.2, 11);
    }
}
