package rigibo.lab.problem;

import rigibo.backend.effect.AirDrag;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.Material;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.List;

/**
 * Stones are thrown through two media.
 *
 * <p>Drag c·v per mass: v′ = g − c·v is linear, so v = v∞ + (v₀ − v∞)·e^(−ct) with v∞ = g/c.
 *
 * <p>Drag ½·ρ·c·A·v², thrown straight up: with ½·ρ·c·A·v_t² = m·g it is v′ = −g·(1 + v²/v_t²) on
 * the way up and v′ = −g·(1 − v²/v_t²) on the way down. Separated and integrated, v = v_t·tan(atan
 * (v₀/v_t) − gt/v_t) up to the top at T = v_t/g·atan(v₀/v_t), and v = −v_t·tanh(g(t − T)/v_t) after
 * it.
 *
 * <p>The error is the largest on the way, since in the end every stone falls at its terminal speed.
 */
final class Drags {

    private static final double SECONDS = 3;
    private static final double RADIUS = 0.5;
    private static final double DENSITY = 1.2;
    private static final double COEFFICIENT = 1.1;

    /** The phases of the linear drag: c in 1/s, velocity to the right and up in m/s. */
    private static final double[][] LINEAR = {{0.5, 8, 0}, {0.5, 9, 14}, {3, 8, 6}, {30, 8, 3}};

    /** The phases of the quadratic drag: terminal and first speed, m/s. */
    private static final double[][] QUADRATIC = {{20, 15}, {20, 33}, {12, 25}, {33, 12}};

    /** The error promised at EXACT, row 3, for quadratic drag; for linear drag it is 1e-9. */
    private static final double EQUAL_BELOW = 1e-6;

    private Drags() {}

    static Problem problem() {
        return new Problem(
                "R2",
                "throws against linear and quadratic drag",
                "largest error of the velocity / first speed",
                EQUAL_BELOW,
                List.of(Line.STEP, Line.STEP_EULER, Line.STEP_VERLET, Line.STEP_RK4, Line.SUBSTEPS),
                Drags::set);
    }

    private static Trial set(Bench bench) {
        Gravity gravity = new Gravity(0, -Earth.GRAVITY);
        World thick = bench.world(Effects.of(gravity, new Drag()));
        for (double[] thrown : LINEAR) {
            thick.add(
                    Solid.disc(RADIUS)
                            .velocity(thrown[1], thrown[2])
                            .material(Material.DEFAULT.drag(thrown[0])));
        }
        World airy = bench.world(Effects.of(gravity, new AirDrag(DENSITY, COEFFICIENT)));
        for (double[] thrown : QUADRATIC) {
            double area = 2 * RADIUS;
            double weight = DENSITY * COEFFICIENT * area * thrown[0] * thrown[0] / 2;
            airy.add(Solid.disc(RADIUS).velocity(0, thrown[1]).mass(weight / Earth.GRAVITY));
        }
        return () -> fly(bench, thick, airy);
    }

    private static Errors fly(Bench bench, World thick, World airy) {
        double[] linear = new double[LINEAR.length];
        double[] quadratic = new double[QUADRATIC.length];
        for (int step = 1; step <= bench.stepsIn(SECONDS); step++) {
            bench.step(thick);
            bench.step(airy);
            double time = step * bench.step();
            for (int i = 0; i < linear.length; i++) {
                linear[i] = Math.max(linear[i], errorOfLinear(thick, i, time));
            }
            for (int i = 0; i < quadratic.length; i++) {
                quadratic[i] = Math.max(quadratic[i], errorOfQuadratic(airy, i, time));
            }
        }
        double one = Mean.of(linear);
        double other = Mean.of(quadratic);
        return Errors.of((one + other) / 2)
                .with("linear drag alone, of the first speed", one)
                .with("quadratic drag alone, of the first speed", other);
    }

    private static double errorOfLinear(World world, int body, double time) {
        double[] thrown = LINEAR[body];
        double left = Math.exp(-thrown[0] * time);
        double vx = thrown[1] * left;
        double vy = thrown[2] * left - Earth.GRAVITY / thrown[0] * (1 - left);
        double error = Math.hypot(world.velocityX(body) - vx, world.velocityY(body) - vy);
        return error / Math.hypot(thrown[1], thrown[2]);
    }

    private static double errorOfQuadratic(World world, int body, double time) {
        double[] thrown = QUADRATIC[body];
        double vy = quadratic(thrown[0], thrown[1], time);
        return Math.hypot(world.velocityX(body), world.velocityY(body) - vy) / thrown[1];
    }

    /** Upward velocity at a time after a throw straight up, m/s. */
    static double quadratic(double terminal, double thrown, double time) {
        double turned = Math.atan(thrown / terminal) - Earth.GRAVITY * time / terminal;
        return terminal * (turned > 0 ? Math.tan(turned) : Math.tanh(turned));
    }
}
