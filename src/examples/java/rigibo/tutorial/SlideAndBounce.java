package rigibo.tutorial;

import rigibo.backend.HitEvent;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.ArrayList;
import java.util.List;

/** Chapter 2: friction stops a crate, and a ball bounces. */
public final class SlideAndBounce {

    static final double STEP = 1.0 / 60; // s
    static final double GRAVITY = 9.81; // m/s²
    static final double SPEED = 6; // m/s, of the crate
    static final double DROP = 4; // m, below the ball

    /** Density 700 kg/m², friction 0.4, elasticity 0. */
    static final Material WOOD = new Material(700, 0.4, 0);

    static final Material RUBBER = new Material(1100, 0.9, 0.8);

    private SlideAndBounce() {}

    /** Adds a wooden floor, a crate that slides over it, and a rubber ball thrown above it. */
    static void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5).material(WOOD));
        pool.add(
                BodyDefinition.dynamic(Polygon.box(1.2, 0.6))
                        .at(-4, 0.3)
                        .velocity(SPEED, 0)
                        .material(WOOD));
        pool.add(
                BodyDefinition.dynamic(new Circle(0.3))
                        .at(2, DROP + 0.3)
                        .velocity(2, 0)
                        .material(RUBBER)
                        .name("ball"));
    }

    /** Prints how far the crate slides, and the time between two bounces of the ball. */
    public static void main(String[] arguments) {
        Pool pool = new Pool();
        build(pool);
        RigidBody crate = pool.bodies().get(1);
        double start = crate.x();
        List<Double> bounces = new ArrayList<>();
        for (int i = 0; i < 180; i++) {
            double begun = pool.time();
            pool.step(STEP);
            for (HitEvent hit : pool.hits()) {
                if (hit.a().name().equals("ball") || hit.b().name().equals("ball")) {
                    bounces.add(begun + hit.time());
                }
            }
        }
        double way = SPEED * SPEED / (2 * WOOD.friction() * GRAVITY);
        System.out.printf("slides for %.3f m, by formula %.3f m%n", crate.x() - start, way);
        double between = 2 * RUBBER.elasticity() * Math.sqrt(2 * DROP / GRAVITY);
        System.out.printf(
                "bounces again after %.4f s, by formula %.4f s%n",
                bounces.get(1) - bounces.get(0), between);
    }
}
