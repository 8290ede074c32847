package rigibo.examples;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** Marbles roll from rail to rail into a box. */
public final class MarbleRun implements Exhibit {

    static final double SLOPE = 0.24; // rad
    static final double RADIUS = 0.15; // m
    private static final int RAILS = 4;
    private static final int MARBLES = 8;
    private static final Material GLASS = new Material(25, 0.4, 0.3);

    final List<RigidBody> marbles = new ArrayList<>();
    private double next;

    @Override
    public void build(Pool pool) {
        for (int i = 0; i < RAILS; i++) {
            int side = i % 2 == 0 ? -1 : 1;
            double y = 7.4 - 1.7 * i;
            pool.add(
                    BodyDefinition.fixed(Polygon.box(5, 0.12))
                            .at(side * 0.7, y)
                            .angle(side * SLOPE));
            pool.add(BodyDefinition.fixed(Polygon.box(0.15, 1.2)).at(-side * 3.25, y - 1));
        }
        pool.add(BodyDefinition.fixed(Polygon.box(3, 0.2)).at(-2, 0));
        pool.add(BodyDefinition.fixed(Polygon.box(0.2, 1)).at(-0.6, 0.6));
        pool.add(BodyDefinition.fixed(Polygon.box(0.2, 1)).at(-3.4, 0.6));
    }

    @Override
    public void beforeStep(Pool pool) {
        if (marbles.size() < MARBLES && pool.time() >= next) {
            next += 0.8;
            double along = 2.2; // m, from the middle of the first rail, up its slope
            double off = 0.06 + RADIUS;
            marbles.add(
                    pool.add(
                            BodyDefinition.dynamic(new Circle(RADIUS))
                                    .at(
                                            -0.7
                                                    - along * Angle.cos(SLOPE)
                                                    + off * Angle.sin(SLOPE),
                                            7.4 + along * Angle.sin(SLOPE) + off * Angle.cos(SLOPE))
                                    .material(GLASS)));
        }
    }

    @Override
    public View view() {
        return new View(0, 4.3, 11.5);
    }

    /** Prints how many marbles have arrived, every two seconds. */
    public static void main(String[] arguments) {
        MarbleRun example = new MarbleRun();
        Pool pool = example.open();
        for (int i = 0; i < 12; i++) {
            example.run(pool, 2);
            long arrived = example.marbles.stream().filter(marble -> marble.y() < 1.2).count();
            System.out.printf("%.0f s: %d in the box%n", pool.time(), arrived);
        }
    }
}
