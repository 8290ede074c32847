package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** Static, kinematic and falling sensors: each reports the bodies inside it. */
public final class SensorTypes implements Exhibit {
    private RigidBody driven;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(2, 2)).at(-2.6, 1).sensor());
        driven =
                pool.add(
                        BodyDefinition.kinematic(Polygon.box(1.6, 1.6))
                                .at(0, 1)
                                .spin(0.6)
                                .sensor());
        pool.add(
                BodyDefinition.dynamic(new Circle(0.8))
                        .at(2.8, 8)
                        .mass(1)
                        .gravityScale(0.05)
                        .sensor());
        for (int i = 0; i < 7; i++) {
            pool.add(BodyDefinition.dynamic(Polygon.box(0.5, 0.5)).at(-3.4 + 1.1 * i, 0.25));
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        driven.velocity(1.2 * Angle.cos(pool.time()), 0);
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        for (RigidBody body : pool.bodies()) {
            if (body.isSensor()) {
                pool.inside(body)
                        .forEach(
                                who ->
                                        sketch.line(
                                                body.x(),
                                                body.y(),
                                                who.x(),
                                                who.y(),
                                                Sketch.Tone.GOOD));
            }
        }
    }

    @Override
    public Effects effects() {
        return Effects.usual().with(new Sensors());
    }

    @Override
    public View view() {
        return new View(0, 3, 10);
    }
}
