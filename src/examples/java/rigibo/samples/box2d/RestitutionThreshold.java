package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

import java.util.Locale;

/** A ball of 5 cm/s leaves the wall as fast as it came. */
public final class RestitutionThreshold implements Exhibit {
    private RigidBody ball;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.5, 2)).at(1.05, 1));
        ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.4))
                                .at(0.3, 0.4)
                                .velocity(0.05, 0)
                                .material(new Material(1, 0, 1)));
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count(String.format(Locale.ROOT, "%.4f m/s", ball.velocityX()));
    }

    @Override
    public View view() {
        return new View(0, 1.4, 5);
    }
}
