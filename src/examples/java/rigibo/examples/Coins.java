package rigibo.examples;

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

/**
 * Coins are sensors: they touch nothing, report the bodies inside them, and vanish once the ball
 * was inside.
 */
public final class Coins implements Exhibit {

    static final int COUNT = 7;
    static final double SPEED = 4; // m/s

    RigidBody ball;
    int collected;

    @Override
    public Effects effects() {
        return Effects.usual().with(new Sensors());
    }

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(9, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(0.4, 4)).at(4.2, 2));
        ball = pool.add(BodyDefinition.dynamic(new Circle(0.4)).at(-3.6, 0.4).velocity(SPEED, 6));
        for (int i = 0; i < COUNT; i++) {
            double seconds = 0.25 * (i + 1);
            double x = -3.6 + SPEED * seconds;
            double y = 0.4 + 6 * seconds - 9.81 / 2 * seconds * seconds;
            pool.add(BodyDefinition.fixed(new Circle(0.2)).at(x, Math.max(0.4, y)).sensor());
        }
    }

    @Override
    public void beforeStep(Pool pool) {
        for (SensorEvent event : pool.sensorEvents()) {
            boolean isNew = event.phase() == SensorEvent.Phase.ENTERED;
            if (isNew && event.visitor() == ball && event.sensor().isAlive()) {
                pool.remove(event.sensor());
                collected++;
            }
        }
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count(collected + " / " + COUNT);
    }

    @Override
    public View view() {
        return new View(0, 2, 10);
    }

    /** Prints how many coins were collected, every half second. */
    public static void main(String[] arguments) {
        Coins example = new Coins();
        Pool pool = example.open();
        for (int i = 0; i < 4; i++) {
            example.run(pool, 0.5);
            System.out.printf("%.1f s: %d of %d%n", pool.time(), example.collected, COUNT);
        }
    }
}
