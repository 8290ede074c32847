package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Solid;

/**
 * A box lands flat, without rebound, partly on a platform. Truth: with its centre of mass above the
 * platform the support reaches to both sides of the weight, so it stays as it landed; beyond the
 * edge the weight turns it about the edge and it falls.
 */
final class HalfOnAnEdge implements Scenes {

    private static final double DROP = 0.5;
    private static final double HORIZON = 5;

    @Override
    public void run(Trial trial) {
        for (int percent = 5; percent <= 95; percent += 5) {
            if (percent != 50) {
                land(trial, percent);
            }
        }
        land(trial, 49);
        land(trial, 51);
    }

    private static void land(Trial trial, int percent) {
        trial.variant(percent + " % on the platform");
        WatchedPool pool = trial.earth();
        pool.add(Solid.fixed(10, 1).at(-5, -0.5));
        double x = 0.5 - percent / 100.0;
        RigidBody box = pool.add(Solid.box(1, 1).at(x, 0.5 + DROP));
        pool.run(HORIZON);
        if (percent > 50) {
            double moved = Math.hypot(box.x() - x, box.y() - 0.5);
            trial.measure("moved though it stays", moved, "m", 2e-3);
            trial.measure("turned though it stays", Math.abs(box.angle()), "rad", 2e-3);
        } else {
            trial.require("less than half tips off", box.y() < -1);
        }
    }
}
