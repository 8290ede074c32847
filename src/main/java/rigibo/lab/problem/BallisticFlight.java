package rigibo.lab.problem;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Solid;

import java.util.List;

/**
 * A stone is thrown under gravity alone: x = x₀ + v·t + g·t²/2. The error is its distance from that
 * point after T = 5 s, as a share of the length of its path, which is ∫√(vₓ² + (v_y + g·t)²)dt =
 * |g|·[(s·√(1 + s²) + asinh s)/2 · vₓ²/g²], s = (v_y + g·t)/vₓ.
 */
final class BallisticFlight {

    private static final double GRAVITY = -9.81;
    private static final double SECONDS = 5;

    /** The phases: velocities to the right and up, m/s. */
    private static final double[][] THROWS = {{7, 9}, {3, 24.5}, {20, 0}, {11, -6}};

    private BallisticFlight() {}

    static Problem problem() {
        return new Problem(
                "R1",
                "ballistic flight of 5 s",
                "distance from the parabola / length of the way",
                1e-10,
                List.of(Line.STEP, Line.STEP_EULER, Line.STEP_VERLET, Line.STEP_RK4),
                BallisticFlight::set);
    }

    private static Trial set(Bench bench) {
        World world = bench.world(Effects.of(new Gravity(0, GRAVITY)));
        for (double[] thrown : THROWS) {
            world.add(Solid.disc(0.1).velocity(thrown[0], thrown[1]));
        }
        return () -> fly(bench, world);
    }

    private static Errors fly(Bench bench, World world) {
        int steps = bench.stepsIn(SECONDS);
        for (int i = 0; i < steps; i++) {
            bench.step(world);
        }
        double time = steps * bench.step();
        double sum = 0;
        for (int body = 0; body < THROWS.length; body++) {
            double vx = THROWS[body][0];
            double vy = THROWS[body][1];
            double awayX = world.x(body) - vx * time;
            double awayY = world.y(body) - (vy + GRAVITY / 2 * time) * time;
            sum += Math.hypot(awayX, awayY) / way(vx, vy, time);
        }
        return Errors.of(sum / THROWS.length);
    }

    private static double way(double vx, double vy, double time) {
        double from = vy / vx;
        double to = (vy + GRAVITY * time) / vx;
        return vx * vx / GRAVITY * (arc(to) - arc(from));
    }

    private static double arc(double slope) {
        double root = Math.sqrt(1 + slope * slope);
        return (slope * root + Math.log(slope + root)) / 2;
    }
}
