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
 * Balls with e = 0.8 fall by 2 m and bounce. Truth: {@link Bounces}, apexes of e²ⁿ·H.
 *
 * <p>The highest step would be lower than the apex by up to g·dt²/8. So the apex is y + v²/2g at
 * the first step downwards, where v is small; an engine's behaviour at the impact does not affect
 * it. The impact before an apex precedes it by the time of a rise to that height.
 */
final class Rebounds {

    private static final double ELASTICITY = 0.8;
    private static final double HEIGHT = 2;
    private static final double RADIUS = 0.25;
    private static final int APEXES = 5;

    /** The time added to that of five bounces, s, so that late ones count. */
    private static final double PATIENCE = 1;

    /** Phases of the first impact within a step of the game. */
    private static final int PHASES = 25;

    /** The error promised at EXACT, row 10. */
    private static final double EQUAL_BELOW = 1e-6;

    private Rebounds() {}

    static Problem problem() {
        return new Problem(
                "R6",
                "five bounces of a ball with e = 0.8",
                "largest error of an apex / height of the drop",
                EQUAL_BELOW,
                List.of(Line.STEP, Line.STEP_DISCRETE, Line.STEP_SPLIT, Line.TOLERANCE),
                Rebounds::set);
    }

    private static Trial set(Bench bench) {
        World world = bench.world(Earth.effects().without(Friction.class).without(Rotation.class));
        Rebound[] balls = new Rebound[PHASES];
        for (int i = 0; i < PHASES; i++) {
            double fall = Math.sqrt(2 * HEIGHT / Earth.GRAVITY) + i * Setting.USUAL_STEP / PHASES;
            double height = Bounces.heightOfFall(fall);
            balls[i] = new Rebound(new Bounces(height, ELASTICITY));
            world.add(Solid.disc(RADIUS, 0, ELASTICITY).at(i - PHASES / 2, RADIUS + height));
        }
        world.add(Earth.floor(0, ELASTICITY));
        return () -> bounce(bench, world, balls);
    }

    private static Errors bounce(Bench bench, World world, Rebound[] balls) {
        double fall = Math.sqrt(2 * HEIGHT / Earth.GRAVITY) + Setting.USUAL_STEP;
        double end = new Bounces(Bounces.heightOfFall(fall), ELASTICITY).impactTime(APEXES + 1);
        for (int step = 1; step <= bench.stepsIn(end + PATIENCE); step++) {
            bench.step(world);
            for (int i = 0; i < PHASES; i++) {
                balls[i].see(step * bench.step(), world.y(i) - RADIUS, world.velocityY(i));
            }
        }
        double[] apex = new double[PHASES];
        double[] landing = new double[PHASES];
        for (int i = 0; i < PHASES; i++) {
            if (world.y(i) < -RADIUS) {
                return Errors.failed("ball " + i + " went through the floor");
            }
            if (balls[i].seen < APEXES) {
                return Errors.failed("ball " + i + " bounced " + balls[i].seen + " times only");
            }
            apex[i] = balls[i].apex;
            landing[i] = balls[i].landing;
        }
        return Errors.of(Mean.of(apex)).with("time of landing, s", Mean.of(landing));
    }

    /** The observations of one ball. */
    static final class Rebound {

        private final Bounces truth;
        private boolean isRising;

        /** The number of apexes so far. */
        int seen;

        /** The largest error of an apex, as a share of the height of the drop. */
        double apex;

        /** Largest error of the time of an impact, s. */
        double landing;

        Rebound(Bounces truth) {
            this.truth = truth;
        }

        /**
         * Reads the end of a step: the height above that at which the ball touches, m, and the
         * upward velocity, m/s.
         */
        void see(double time, double above, double velocityY) {
            if (isRising && velocityY <= 0 && seen < APEXES) {
                seen++;
                double reached = Bounces.apexOf(above, velocityY);
                apex = Math.max(apex, Math.abs(reached - truth.apex(seen)) / truth.apex(0));
                double rise = Math.sqrt(2 * Math.max(reached, 0) / Earth.GRAVITY);
                double impact = time + velocityY / Earth.GRAVITY - rise;
                landing = Math.max(landing, Math.abs(impact - truth.impactTime(seen)));
            }
            isRising = velocityY > 0;
        }
    }
}
