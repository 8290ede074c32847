package rigibo.lab.problem;

import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Rotation;
import rigibo.lab.engine.Line;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;
import rigibo.lab.truth.Bounces;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.List;

/**
 * 49 elastic balls are dropped by 5 m, side by side, and bounce for 20 s. Truth: their energy
 * Σm(v²/2 + g·(y − r)) stays E₀ = Σm·g·h. The error is √mean(E − E₀)²/E₀ over all steps, as in the
 * bouncing test of SimBenchmark (leggedrobotics.github.io/SimBenchmark, 2018), where engines for
 * robotics err by 6e-6 to 1e-2 at steps of 1 ms. The balls start at heights up to 17 cm apart, so
 * that their first impacts are spread over one step of the game, since errors depend on where in
 * the step the impact falls.
 */
final class ElasticBalls {

    private static final int BALLS = 49;
    private static final double SECONDS = 20;
    private static final double DROP = 5;
    private static final double RADIUS = 0.1;
    private static final double MASS = 10;
    private static final double DISTANCE = 0.5;

    /** The error promised at EXACT, row 10: the apex after ten bounces, which is the energy. */
    private static final double EQUAL_BELOW = 1e-6;

    private ElasticBalls() {}

    static Problem problem() {
        return new Problem(
                "R5",
                "49 elastic balls bouncing for 20 s",
                "root mean square change of energy / energy",
                EQUAL_BELOW,
                List.of(Line.STEP, Line.STEP_DISCRETE, Line.STEP_SPLIT),
                ElasticBalls::set);
    }

    private static Trial set(Bench bench) {
        World world = bench.world(Earth.effects().without(Friction.class).without(Rotation.class));
        for (int i = 0; i < BALLS; i++) {
            world.add(
                    Solid.disc(RADIUS, 0, 1)
                            .at(DISTANCE * (i - BALLS / 2), RADIUS + height(i))
                            .mass(MASS));
        }
        world.add(Earth.floor(0, 1));
        return () -> bounce(bench, world);
    }

    private static double height(int ball) {
        double fall = Math.sqrt(2 * DROP / Earth.GRAVITY);
        return Bounces.heightOfFall(fall + ball * Setting.USUAL_STEP / BALLS);
    }

    private static Errors bounce(Bench bench, World world) {
        double[] start = new double[BALLS];
        for (int i = 0; i < BALLS; i++) {
            start[i] = MASS * Earth.GRAVITY * height(i);
        }
        double sum = Mean.of(start) * BALLS;
        double squares = 0;
        double worst = 0;
        int steps = bench.stepsIn(SECONDS);
        for (int step = 0; step < steps; step++) {
            bench.step(world);
            double change = 0;
            for (int i = 0; i < BALLS; i++) {
                if (world.y(i) < -RADIUS) {
                    return Errors.failed("ball " + i + " went through the floor");
                }
                double gain = energy(world, i) - start[i];
                change += gain;
                worst = Math.max(worst, Math.abs(gain) / start[i]);
            }
            squares += change * change;
        }
        return Errors.of(Math.sqrt(squares / steps) / sum)
                .with("largest change of a ball's energy, of its energy", worst);
    }

    private static double energy(World world, int ball) {
        double apex = Bounces.apexOf(world.y(ball) - RADIUS, world.velocityY(ball));
        return MASS * Earth.GRAVITY * apex;
    }
}
