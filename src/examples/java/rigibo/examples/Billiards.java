package rigibo.examples;

import rigibo.backend.Pool;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Restitution;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Exponential;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.Sketch;
import rigibo.frontend.gallery.View;

import java.util.Locale;

/** Seen from above: no gravity, balls of elasticity 1 that the cloth slows down evenly. */
public final class Billiards implements Exhibit {

    static final double CLOTH = 0.25; // 1/s
    static final double SPEED = 6; // m/s
    private static final double RADIUS = 0.12; // m
    private static final Material IVORY = new Material(100, 0, 1).drag(CLOTH);

    @Override
    public Effects effects() {
        return Effects.of(new Contacts(), new Restitution(), new ContinuousImpacts(), new Drag());
    }

    @Override
    public void build(Pool pool) {
        for (int side = -1; side <= 1; side += 2) {
            pool.add(BodyDefinition.fixed(Polygon.box(4.6, 0.3)).at(0, side * 3.65));
            pool.add(BodyDefinition.fixed(Polygon.box(0.3, 7)).at(side * 2.15, 0));
        }
        for (int row = 0; row < 5; row++) {
            for (int i = 0; i <= row; i++) {
                double x = (i - row / 2.0) * 2.02 * RADIUS;
                ball(pool, x, 1.2 + row * 1.75 * RADIUS, 0);
            }
        }
        ball(pool, 0.03, -2.2, SPEED);
    }

    private static void ball(Pool pool, double x, double y, double up) {
        pool.add(
                BodyDefinition.dynamic(new Circle(RADIUS))
                        .at(x, y)
                        .velocity(0, up)
                        .material(IVORY));
    }

    @Override
    public void sketch(Pool pool, Sketch sketch) {
        sketch.count(String.format(Locale.ROOT, "%.2f J", pool.kineticEnergy()));
    }

    @Override
    public View view() {
        return new View(0, 0, 10);
    }

    /** Prints the energy, which falls as e^(−2kt) however the balls meet. */
    public static void main(String[] arguments) {
        Billiards example = new Billiards();
        Pool pool = example.open();
        double atFirst = pool.kineticEnergy();
        for (int i = 0; i < 5; i++) {
            example.run(pool, 1);
            double expected = atFirst * Exponential.exp(-2 * CLOTH * pool.time());
            System.out.printf(
                    "%.0f s: %.6f of %.6f J%n", pool.time(), pool.kineticEnergy(), expected);
        }
    }
}
