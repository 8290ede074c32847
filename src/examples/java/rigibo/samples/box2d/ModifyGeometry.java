package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.geometry.Shape;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A driven body changes its shape twice a second under a box. */
public final class ModifyGeometry implements Exhibit {
    private RigidBody changing;
    private int count;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        changing = pool.add(BodyDefinition.kinematic(new Circle(0.5)).at(0, 0.8));
        pool.add(BodyDefinition.dynamic(Polygon.box(1.2, 1.2)).at(0.1, 3));
    }

    @Override
    public void beforeStep(Pool pool) {
        int due = (int) (2 * pool.time());
        if (due > count) {
            count = due;
            Shape[] shapes = {
                new Circle(0.5),
                new Capsule(0.6, 0.3),
                Polygon.regular(3, 0.7),
                Polygon.box(1.4, 0.6)
            };
            changing.shape(shapes[count % shapes.length]);
        }
    }

    @Override
    public View view() {
        return new View(0, 2, 8);
    }
}
