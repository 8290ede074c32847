package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

/**
 * Truth: without gravity and with e = 1 a ball between walls keeps its speed for ever, however slow
 * it is. A least speed of rebound would glue it to the wall.
 */
final class SlowBall implements Scenes {

    private static final double RADIUS = 0.1;
    private static final int BOUNCES = 1000;

    /** Speeds in m/s and free widths in m: a bounce takes three steps or more. */
    private static final double[][] SPEEDS = {{1e-3, 2e-3}, {1e-2, 2e-3}, {0.1, 1e-2}, {1, 0.05}};

    @Override
    public void run(Trial trial) {
        for (double[] each : SPEEDS) {
            trial.variant(each[0] + " m/s straight");
            bounce(trial, each[0], 0, each[1]);
            trial.variant(each[0] + " m/s diagonal");
            bounce(trial, 0.8 * each[0], 0.6 * each[0], each[1]);
        }
    }

    private static void bounce(Trial trial, double vx, double vy, double way) {
        WatchedPool pool = trial.space();
        double inside = 2 * RADIUS + way;
        for (int side = -1; side <= 1; side += 2) {
            BodyDefinition wall = Solid.fixed(1, 1, 0, 1);
            pool.add(wall.at(side * (inside + 1) / 2, 0));
            pool.add(wall.at(0, side * (inside + 1) / 2));
        }
        RigidBody ball =
                pool.add(Solid.disc(RADIUS, 0, 1).at(0.13 * way, 0.21 * way).velocity(vx, vy));
        double speed = Math.hypot(vx, vy);
        pool.run(BOUNCES * way / speed);
        double change = Math.hypot(ball.velocityX(), ball.velocityY()) / speed - 1;
        trial.measure("speed changed", Math.abs(change), "of v", 1e-9, 1e-6);
        trial.require("stays inside", Math.abs(ball.x()) < way && Math.abs(ball.y()) < way);
    }
}
