package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Logarithm;
import rigibo.lab.truth.Solid;

import java.util.Random;

/**
 * Ten thousand balls of 0.1 m at 50 to 2,000 m/s against walls of 1 mm to 1 m, at 30 to 240 steps
 * per second. Truth: none passes the near face, and each leaves it with −e of its normal velocity.
 * That holds at DRAFT, too: a lone disc meets a face on a straight line, so its impact has a closed
 * form, however far it moves in a step.
 */
final class Bullets implements Scenes {

    private static final long SEED = 40;
    private static final int COUNT = 10_000;
    private static final double RADIUS = 0.1;
    private static final double WALL_HEIGHT = 20;

    @Override
    public void run(Trial trial) {
        Random random = new Random(SEED);
        int misses = 0;
        for (int i = 0; i < COUNT; i++) {
            trial.variant("seed " + SEED + ", bullet " + i);
            boolean isStopped = shoot(trial, random);
            trial.require("stopped at the near face", isStopped);
            misses += isStopped ? 0 : 1;
        }
        trial.measure("misses of 10,000", misses, "bullets", 0);
    }

    private static boolean shoot(Trial trial, Random random) {
        double speed = between(random, 50, 2000);
        double thickness = between(random, 1e-3, 1);
        double dt = 1 / between(random, 30, 240);
        double e = random.nextDouble();
        double angle = Math.toRadians(90 * (random.nextDouble() - 0.5));
        double way = RADIUS + 0.01 + random.nextDouble() * 4;
        double vx = speed * Angle.cos(angle);
        double vy = speed * Angle.sin(angle);
        WatchedPool pool = trial.space();
        pool.add(Solid.fixed(thickness, WALL_HEIGHT, 0, e).at(thickness / 2, 0));
        // Aimed at the middle of the wall.
        RigidBody ball =
                pool.add(
                        Solid.disc(RADIUS, 0, e)
                                .at(-way, -(way - RADIUS) * vy / vx)
                                .velocity(vx, vy));
        double impact = (way - RADIUS) / vx;
        boolean isStopped = true;
        while (pool.time() < impact + 2 * dt) {
            pool.step(dt);
            isStopped &= ball.x() < -RADIUS * 0.98;
        }
        double rebound = Math.abs(ball.velocityX() + e * vx) / vx;
        trial.measure("normal velocity", rebound, "of v", 1e-9, 1e-3);
        return isStopped;
    }

    /** A number whose logarithm is uniform, so that slow and fast are equally frequent. */
    private static double between(Random random, double least, double most) {
        return least * Logarithm.pow(most / least, random.nextDouble());
    }
}
