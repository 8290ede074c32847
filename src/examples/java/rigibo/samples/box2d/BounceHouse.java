package rigibo.samples.box2d;

import rigibo.backend.ContactEvent;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Length;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

import java.util.Locale;

/** Elasticity 1, no friction, no gravity: its speed never changes. */
public final class BounceHouse implements Exhibit {
    private RigidBody ball;

    @Override
    public void build(Pool pool) {
        for (int side = -1; side <= 1; side += 2) {
            pool.add(BodyDefinition.fixed(Polygon.box(9, 0.5)).at(0, side * 4.25));
            pool.add(BodyDefinition.fixed(Polygon.box(0.5, 8)).at(side * 4.25, 0));
        }
        ball =
                pool.add(
                        BodyDefinition.dynamic(new Circle(0.3))
                                .at(0.1, 0.2)
                                .velocity(11, 7)
                                .material(new Material(1, 0, 1)));
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        for (ContactEvent contact : pool.contactEvents()) {
            sketch.point(contact.x(), contact.y(), Sketch.Tone.BAD);
        }
        sketch.count(
                String.format(
                        Locale.ROOT, "%.6f m/s", Length.hypot(ball.velocityX(), ball.velocityY())));
    }

    @Override
    public Effects effects() {
        return Effects.usual().without(Gravity.class);
    }

    @Override
    public View view() {
        return new View(0, 0, 11.5);
    }
}
