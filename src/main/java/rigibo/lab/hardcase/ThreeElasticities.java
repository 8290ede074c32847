package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Bounces;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

/**
 * Boxes dropped flat from 2 m. Truth: with e = 1 the box returns to its height for ever, here forty
 * times; with e = ½ it stops after T = t1(1 + e)/(1 − e); with e = 0 it stays where it lands. The
 * limit of an apex grows by that of ten bounces every ten bounces.
 */
final class ThreeElasticities implements Scenes {

    private static final double HEIGHT = 2;
    private static final int BOUNCES = 40;

    @Override
    public void run(Trial trial) {
        trial.variant("e 1");
        bounceOn(trial);
        trial.variant("e 0.5");
        stop(trial, 0.5);
        trial.variant("e 0");
        stop(trial, 0);
    }

    private static RigidBody drop(WatchedPool pool, double e) {
        pool.add(Earth.floor(0.5, e));
        return pool.add(Solid.box(1, 1, 0.5, e).at(0, 0.5 + HEIGHT));
    }

    private static void bounceOn(Trial trial) {
        WatchedPool pool = trial.earth();
        RigidBody box = drop(pool, 1);
        Bounces truth = new Bounces(HEIGHT, 1);
        double tens = BOUNCES / 10.0;
        while (pool.time() < truth.impactTime(BOUNCES)) {
            pool.step();
            trial.relativeError(
                    "apex",
                    Bounces.apexOf(box.y() - 0.5, box.velocityY()),
                    HEIGHT,
                    "of H",
                    1e-6 * tens,
                    5e-3 * tens);
        }
    }

    private static void stop(Trial trial, double e) {
        WatchedPool pool = trial.earth();
        RigidBody box = drop(pool, e);
        Bounces truth = new Bounces(HEIGHT, e);
        pool.run(truth.restTime() + 2 * Trial.DT);
        while (pool.time() < truth.restTime() + 5) {
            pool.step();
            double off = Math.abs(Bounces.apexOf(box.y() - 0.5, box.velocityY()));
            trial.measure("leaves the floor", off, "m", 2 * Trial.TOLERATED_OVERLAP);
            trial.measure("moves sideways", Math.abs(box.x()), "m", 1e-6);
        }
    }
}
