package rigibo.tutorial;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

/** Chapter 5: a program tries throws in copies of a pool, then makes the best one. */
public final class LookAhead {

    static final double STEP = 1.0 / 60; // s
    static final double GRAVITY = 9.81; // m/s²
    static final double SPEED = 9; // m/s
    static final double RADIUS = 0.2; // m

    private LookAhead() {}

    /** Adds a floor and a ball that lies on it. */
    static void build(Pool pool) {
        pool.add(BodyDefinition.fixed(Polygon.box(30, 1)).at(5, -0.5));
        pool.add(BodyDefinition.dynamic(new Circle(RADIUS)).at(0, RADIUS));
    }

    static RigidBody ball(Pool pool) {
        return pool.bodies().get(1);
    }

    static void launch(RigidBody ball, double degrees) {
        double angle = Angle.ofDegrees(degrees);
        ball.velocity(SPEED * Angle.cos(angle), SPEED * Angle.sin(angle));
    }

    /** Throws the ball of a pool at an angle, and returns where it lands. */
    static double land(Pool pool, double degrees) {
        launch(ball(pool), degrees);
        do {
            pool.step(STEP);
        } while (pool.hits().isEmpty());
        return pool.hits().get(0).x();
    }

    /** Prints the angle that throws farthest, and whether the real throw repeats the trial. */
    public static void main(String[] arguments) {
        Pool pool = new Pool();
        build(pool);
        byte[] before = pool.snapshot();
        double best = 0;
        double farthest = 0;
        for (int degrees = 15; degrees <= 75; degrees++) {
            double x = land(Pool.restore(before), degrees);
            best = x > farthest ? degrees : best;
            farthest = Math.max(farthest, x);
        }
        System.out.printf("farthest at %.0f degrees, by formula 45%n", best);
        System.out.printf(
                "lands %.3f m away, by formula %.3f m%n", farthest, SPEED * SPEED / GRAVITY);
        Pool trial = Pool.restore(before);
        land(trial, best);
        land(pool, best);
        System.out.printf("the same bits: %b%n", trial.stateHash() == pool.stateHash());
    }
}
