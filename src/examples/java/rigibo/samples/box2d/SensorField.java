package rigibo.samples.box2d;

import rigibo.backend.Pool;
import rigibo.backend.SensorEvent;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sensors;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

/** A field of sensors counts what falls through it. */
public final class SensorField implements Exhibit {
    private int inside;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(14, 1)).at(0, -0.5));
        for (int i = 0; i < 60; i++) {
            pool.add(
                    BodyDefinition.fixed(Polygon.box(0.5, 0.3))
                            .at(-3.6 + 0.8 * (i % 10), 1 + 0.8 * (i / 10))
                            .sensor());
        }
        for (int i = 0; i < 50; i++) {
            pool.add(
                    BodyDefinition.dynamic(new Circle(0.12))
                            .at(-3.7 + 0.76 * (i % 10) + 0.04 * (i / 10), 6.5 + 0.5 * (i / 10)));
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        for (SensorEvent event : pool.sensorEvents()) {
            inside +=
                    event.phase() == SensorEvent.Phase.ENTERED
                            ? 1
                            : event.phase() == SensorEvent.Phase.LEFT ? -1 : 0;
        }
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count(String.valueOf(inside));
    }

    @Override
    public Effects effects() {
        return Effects.usual().with(new Sensors());
    }

    @Override
    public View view() {
        return new View(0, 3.6, 10.5);
    }
}
