package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * A cue ball runs straight into a rack of fifteen, all smooth and elastic. Truth: the scene is its
 * own mirror image and stays symmetric; energy and momentum are kept.
 */
final class Rack implements Scenes {

    private static final double RADIUS = 0.03;
    private static final double SPEED = 5;
    private static final int ROWS = 5;
    private static final double HORIZON = 0.2;

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.space();
        BodyDefinition ball = Solid.disc(RADIUS, 0, 1);
        RigidBody cue = pool.add(ball.at(-0.3, 0).velocity(SPEED, 0));
        List<RigidBody[]> rows = new ArrayList<>();
        for (int row = 0; row < ROWS; row++) {
            RigidBody[] balls = new RigidBody[row + 1];
            for (int i = 0; i <= row; i++) {
                double x = row * RADIUS * Math.sqrt(3);
                balls[i] = pool.add(ball.at(x, (2 * i - row) * RADIUS));
            }
            rows.add(balls);
        }
        double energy = pool.pool().kineticEnergy();
        while (pool.time() < HORIZON) {
            pool.step();
            trial.measure("asymmetry", asymmetry(rows), "m", 1e-9);
            trial.measure("cue off its line", Math.abs(cue.y()), "m", 1e-9);
        }
        trial.require("the rack was struck", cue.velocityX() < SPEED);
        trial.relativeError("energy changed", pool.pool().kineticEnergy(), energy, "of E", 1e-9);
    }

    private static double asymmetry(List<RigidBody[]> rows) {
        double most = 0;
        for (RigidBody[] balls : rows) {
            for (int i = 0; i < balls.length; i++) {
                RigidBody twin = balls[balls.length - 1 - i];
                double off = Math.hypot(balls[i].x() - twin.x(), balls[i].y() + twin.y());
                most = Math.max(most, off);
            }
        }
        return most;
    }
}
