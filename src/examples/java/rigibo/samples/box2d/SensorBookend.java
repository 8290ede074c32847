package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.SensorEvent;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** A body that is taken out and put back leaves and enters. */
public final class SensorBookend implements Exhibit {
    private RigidBody ball;
    private RigidBody sensor;
    private int count;
    private int events;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        sensor = pool.add(BodyDefinition.fixed(Polygon.box(3, 2)).at(0, 1).sensor());
        ball = pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(0, 0.5));
    }

    @Override
    public void beforeStep(Pool pool) {
        events +=
                (int)
                        pool.sensorEvents().stream()
                                .filter(event -> event.phase() != SensorEvent.Phase.INSIDE)
                                .count();
        if (pool.time() >= 1.5 * (count + 1)) {
            count++;
            if (count % 2 == 1) {
                ball.disable();
            } else {
                ball.enable();
            }
        }
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count(String.valueOf(events));
        boolean isInside = pool.isInside(sensor, ball);
        sketch.point(0, 2.4, isInside ? Sketch.Tone.GOOD : Sketch.Tone.BAD);
    }

    @Override
    public Effects effects() {
        return Effects.usual().with(new Sensors());
    }

    @Override
    public View view() {
        return new View(0, 2, 8);
    }
}
