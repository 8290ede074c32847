package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

/**
 * Truth: a box on the floor stays where it is, and in every step the floor's impulse balances its
 * weight, m·g·dt. Sleep is off.
 */
final class OneBox implements Scenes {

    private static final double HORIZON = 60;

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.earth();
        RigidBody floor = pool.add(Earth.floor(0.5, 0));
        RigidBody box = pool.add(Solid.box(1, 1).at(0, 0.5));
        pool.run(1);
        double x = box.x();
        double y = box.y();
        double weight = box.mass() * Trial.GRAVITY * Trial.DT;
        while (pool.time() < HORIZON) {
            pool.step();
            double drift = Math.hypot(box.x() - x, box.y() - y);
            trial.measure("drift", drift, "m", 1e-9, 1e-4);
            double impulse = pool.impulseBetween(floor, box);
            trial.relativeError("impulse", impulse, weight, "of mg·dt", 1e-6, 1e-2);
            trial.measure("speed", Math.hypot(box.velocityX(), box.velocityY()), "m/s", 1e-6);
        }
        double atRest = 2 * Trial.TOLERATED_OVERLAP;
        trial.measure("overlap at rest", pool.overlapNow(), "width", atRest);
    }
}
