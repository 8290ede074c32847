package rigibo.examples;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Compound;
import rigibo.backend.geometry.Part;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

import java.util.ArrayList;
import java.util.List;

/** A cup, one body of three boxes, carries balls across a gap and pours them out. */
public final class CarryingCup implements Exhibit {

    static final double FAR = 1.8; // m
    private static final double NEAR = -2.3; // m
    private static final double LEAVES = 1.5; // s
    private static final double POURS = 4.5; // s

    RigidBody cup;
    final List<RigidBody> balls = new ArrayList<>();
    private int orders;

    @Override
    public void build(Pool pool) {
        Compound shape =
                Compound.of(
                        Part.of(Polygon.box(1.6, 0.15)),
                        Part.of(Polygon.box(0.15, 1.2)).at(-0.725, 0.6),
                        Part.of(Polygon.box(0.15, 1.2)).at(0.725, 0.6));
        cup = pool.add(BodyDefinition.kinematic(shape).at(NEAR, 4));
        for (int i = 0; i < 12; i++) {
            double x = NEAR - 0.4 + 0.4 * (i % 3);
            balls.add(
                    pool.add(
                            BodyDefinition.dynamic(new Circle(0.15))
                                    .at(x + 0.02 * (i / 3), 4.2 + 0.32 * (i / 3))));
        }
        pool.add(BodyDefinition.fixed(Polygon.box(3.4, 0.3)).at(FAR + 0.7, 0.15));
        pool.add(BodyDefinition.fixed(Polygon.box(0.3, 1.5)).at(FAR - 0.85, 0.9));
        pool.add(BodyDefinition.fixed(Polygon.box(0.3, 1.5)).at(FAR + 2.25, 0.9));
    }

    @Override
    public void beforeStep(Pool pool) {
        if (orders == 0 && pool.time() >= LEAVES) {
            cup.driveTo(FAR, 4, 0, 2.5);
            orders++;
        } else if (orders == 1 && pool.time() >= POURS) {
            cup.driveTo(FAR, 4, -2.6, 1.5);
            orders++;
        }
    }

    @Override
    public View view() {
        return new View(0.6, 3, 9);
    }

    /** Prints how many balls are below the cup in the end. */
    public static void main(String[] arguments) {
        CarryingCup example = new CarryingCup();
        example.run(example.open(), 9);
        long poured = example.balls.stream().filter(ball -> ball.y() < 2).count();
        System.out.printf("%d of %d balls are in the box%n", poured, example.balls.size());
    }
}
