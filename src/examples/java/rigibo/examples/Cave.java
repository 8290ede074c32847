package rigibo.examples;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Capsule;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** A cave is one chain round the air in it, clockwise: matter lies to the left of the way. */
public final class Cave implements Exhibit {

    static final double HALF_WIDTH = 4; // m
    private static final int CORNERS = 60;
    private static final Material ROCK = new Material(1, 0.4, 0.1);

    final List<RigidBody> guests = new ArrayList<>();

    @Override
    public void build(Pool pool) {
        double[] xy = new double[2 * CORNERS];
        for (int i = 0; i < CORNERS; i++) {
            double way = -2 * Math.PI * i / CORNERS;
            double rough = 1 + 0.08 * Angle.sin(7 * way) + 0.05 * Angle.cos(11 * way);
            xy[2 * i] = HALF_WIDTH * rough * Angle.cos(way);
            xy[2 * i + 1] = 4 + 3 * rough * Angle.sin(way);
        }
        pool.add(BodyDefinition.fixed(Chain.loop(xy)).material(ROCK));
        for (int i = 0; i < 30; i++) {
            BodyDefinition guest =
                    switch (i % 3) {
                        case 0 -> BodyDefinition.dynamic(new Circle(0.22));
                        case 1 -> BodyDefinition.dynamic(new Capsule(0.2, 0.15));
                        default -> BodyDefinition.dynamic(Polygon.box(0.4, 0.4));
                    };
            guests.add(pool.add(guest.at(-2.2 + 0.5 * (i % 10), 3.6 + 0.6 * (i / 10))));
        }
    }

    @Override
    public View view() {
        return new View(0, 4, 10);
    }

    /** Prints the lowest and the highest guest of the cave after ten seconds. */
    public static void main(String[] arguments) {
        Cave example = new Cave();
        example.run(example.open(), 10);
        double lowest = example.guests.stream().mapToDouble(RigidBody::y).min().orElseThrow();
        double highest = example.guests.stream().mapToDouble(RigidBody::y).max().orElseThrow();
        System.out.printf("from %.2f m to %.2f m%n", lowest, highest);
    }
}
