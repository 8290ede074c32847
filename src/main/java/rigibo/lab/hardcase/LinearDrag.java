package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Drag;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Solid;

/**
 * Truth: v′ = g − cv gives v = v∞ + (v0 − v∞)e^(−ct) with v∞ = g/c, and x = x0 + v∞t + (v0 − v∞)(1
 * − e^(−ct))/c. At c = 30 a step of 1/(1 + c·dt) would leave 0.667 of a speed where 0.607 is right.
 */
final class LinearDrag implements Scenes {

    private static final double SPEED = 8;
    private static final double HORIZON = 2;

    @Override
    public void run(Trial trial) {
        for (double c : new double[] {0.5, 30}) {
            trial.variant("c " + c);
            fly(trial, c);
        }
    }

    private static void fly(Trial trial, double c) {
        WatchedPool pool = trial.pool(Effects.of(new Gravity(0, -Trial.GRAVITY), new Drag()));
        RigidBody ball =
                pool.add(Solid.disc(0.5).velocity(SPEED, 0).material(Material.DEFAULT.drag(c)));
        double terminal = -Trial.GRAVITY / c;
        for (int i = 1; i <= Math.round(HORIZON / Trial.DT); i++) {
            pool.step();
            double t = i * Trial.DT;
            double left = Math.exp(-c * t);
            double vx = SPEED * left;
            double vy = terminal * (1 - left);
            double error = Math.hypot(ball.velocityX() - vx, ball.velocityY() - vy);
            trial.measure("velocity", error / SPEED, "of v0", 1e-9);
            double x = SPEED * (1 - left) / c;
            double y = terminal * t - terminal * (1 - left) / c;
            trial.measure(
                    "place", Math.hypot(ball.x() - x, ball.y() - y) / (SPEED / c), "of v0/c", 1e-9);
        }
    }
}
