package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

import java.util.Locale;

/** Told to fall at 20 m/s in every step, the box stays on the floor. */
public final class SetVelocity implements Exhibit {
    private RigidBody box;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        box = pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, 0.5));
    }

    @Override
    public void beforeStep(Pool pool) {
        box.velocity(0, -20);
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count(String.format(Locale.ROOT, "%.3f mm", 1000 * Math.max(0, 0.5 - box.y())));
    }

    @Override
    public View view() {
        return new View(0, 2, 8);
    }
}
