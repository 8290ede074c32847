package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A driven wall pushes scrap of all shapes to and fro. */
public final class Junkyard implements Exhibit {
    private RigidBody pusher;
    private int count;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 6)).at(4.4, 3));
        pusher = pool.add(BodyDefinition.kinematic(Polygon.box(0.5, 2)).at(-4.4, 1));
        Shape[] scrap = {
            Compound.ofOutline(0, 0, 0.6, 0, 0.6, 0.2, 0.2, 0.2, 0.2, 0.6, 0, 0.6),
            new Capsule(0.3, 0.12),
            Polygon.regular(6, 0.3),
            Polygon.box(0.8, 0.15),
            new Circle(0.2)
        };
        for (int i = 0; i < 90; i++) {
            pool.add(
                    BodyDefinition.dynamic(scrap[i % 5])
                            .at(-3 + 0.8 * (i % 9), 0.6 + 0.8 * (i / 9))
                            .angle(i));
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        if (pool.time() >= 4 * count) {
            pusher.driveTo(count % 2 == 0 ? 0.5 : -4.4, 1, 0, 3.5);
            count++;
        }
    }

    @Override
    public View view() {
        return new View(0, 3.4, 10);
    }
}
