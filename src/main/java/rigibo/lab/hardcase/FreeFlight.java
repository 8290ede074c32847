package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Rotation;
import rigibo.lab.truth.Solid;

/**
 * Truth: without contacts x = x0 + vt + gt²/2 and θ = θ0 + ωt, at any dt. Errors are shares of the
 * way |v|t + gt²/2 and of the angle turned. (Symplectic Euler would err by g·dt·t/2.)
 */
final class FreeFlight implements Scenes {

    private static final double HORIZON = 2;
    private static final int[] STEPS_PER_SECOND = {2, 30, 60, 240};

    @Override
    public void run(Trial trial) {
        for (int rate : STEPS_PER_SECOND) {
            trial.variant("dropped, " + rate + " steps/s");
            fly(trial, 0, 0, 0, rate);
            trial.variant("thrown, " + rate + " steps/s");
            fly(trial, 7, 9, 11, rate);
        }
    }

    private static void fly(Trial trial, double vx, double vy, double spin, int rate) {
        Effects effects = Effects.of(new Gravity(0, -Trial.GRAVITY), new Rotation());
        WatchedPool pool = trial.pool(effects);
        RigidBody ball = pool.add(Solid.disc(0.5).at(3, 50).velocity(vx, vy).spin(spin));
        for (int i = 1; i <= HORIZON * rate; i++) {
            pool.step(1.0 / rate);
            double t = (double) i / rate;
            double x = 3 + vx * t;
            double y = 50 + vy * t - Trial.GRAVITY * t * t / 2;
            double way = Math.hypot(vx, vy) * t + Trial.GRAVITY * t * t / 2;
            double error = Math.hypot(ball.x() - x, ball.y() - y) / way;
            trial.measure("place", error, "of way", 1e-10, 1e-9);
            if (spin != 0) {
                double turned = spin * t;
                trial.relativeError("angle", ball.angle(), turned, "of angle", 1e-10, 1e-9);
            }
        }
    }
}
