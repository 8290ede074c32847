package rigibo.tutorial;

import rigibo.backend.HitEvent;
import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/** Chapter 1: a box falls on a floor. */
public final class FallingBox {

    static final double STEP = 1.0 / 60; // s
    static final double GRAVITY = 9.81; // m/s²
    static final double HEIGHT = 5; // m, below the box

    private FallingBox() {}

    /** Adds a floor, whose top is at y = 0, and a box above it. */
    static RigidBody build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(20, 1)).at(0, -0.5));
        return pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, HEIGHT + 0.5));
    }

    /** Prints when and how fast the box lands, and where it rests. */
    public static void main(String[] arguments) {
        Pool pool = new Pool();
        RigidBody box = build(pool);
        double begun = 0;
        while (pool.hits().isEmpty()) {
            begun = pool.time();
            pool.step(STEP);
        }
        HitEvent hit = pool.hits().get(0);
        double fall = Math.sqrt(2 * HEIGHT / GRAVITY);
        System.out.printf("falls for %.4f s, by formula %.4f s%n", begun + hit.time(), fall);
        System.out.printf("lands at %.3f m/s, by formula %.3f m/s%n", hit.speed(), GRAVITY * fall);
        while (box.isAwake()) {
            pool.step(STEP);
        }
        System.out.printf("rests at a height of %.3f m%n", box.y());
    }
}
