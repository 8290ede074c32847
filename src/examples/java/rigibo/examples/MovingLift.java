package rigibo.examples;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.frontend.gallery.Exhibit;
import rigibo.frontend.gallery.View;

/** A lift takes along whatever stands on it; a shelf lets a ball pass from below, not back. */
public final class MovingLift implements Exhibit {

    static final double RISE = 4; // m
    private static final double TRAVEL = 2; // s
    private static final double PAUSE = 1; // s

    RigidBody lift;
    RigidBody crate;
    RigidBody shelf;
    RigidBody ball;
    private double next;
    private boolean isUp;

    @Override
    public void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(3, 1)).at(-3, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(3, 1)).at(3, RISE - 0.5));
        lift = pool.add(BodyDefinition.kinematic(Polygon.box(2.4, 0.2)).at(0, -0.1));
        crate = pool.add(BodyDefinition.dynamic(Polygon.box(0.8, 0.8)).at(-0.5, 0.4));
        pool.add(BodyDefinition.dynamic(Polygon.box(0.5, 0.5)).at(-0.5, 1.05));
        shelf =
                pool.add(
                        BodyDefinition.fixed(Polygon.box(2, 0.2))
                                .at(-3.2, 2.4)
                                .material(Material.DEFAULT.oneWay(0, 1)));
        ball = pool.add(BodyDefinition.dynamic(new Circle(0.3)).at(-3.2, 0.3).velocity(0, 8));
    }

    @Override
    public void beforeStep(Pool pool) {
        if (pool.time() >= next) {
            isUp = !isUp;
            lift.driveTo(0, isUp ? RISE - 0.1 : -0.1, 0, TRAVEL);
            next += TRAVEL + PAUSE;
        }
    }

    @Override
    public View view() {
        return new View(0, 2, 9);
    }

    /** Prints how high lift and crate are, every half second. */
    public static void main(String[] arguments) {
        MovingLift example = new MovingLift();
        Pool pool = example.open();
        for (int i = 0; i < 12; i++) {
            example.run(pool, 0.5);
            double crate = example.crate.y() - 0.4;
            System.out.printf(
                    "%.1f s: lift %.3f m, crate %.3f m%n",
                    pool.time(), example.lift.y() + 0.1, crate);
        }
    }
}
