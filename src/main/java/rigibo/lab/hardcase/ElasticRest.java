package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * Bodies of e = 1 on a floor of e = 1: placed, dropped by 1 mm, and three on each other. Truth:
 * energy never rises, so no hop is higher than the drop. Gains are compared with the energy of the
 * drop, mg·1 mm a body. A minute of steps rounds a potential energy of up to mg·2.5 m by 3,600 ·
 * 2.5 m · 1.1e-16 = 1e-12 m of height, 1e-9 of the drop.
 */
final class ElasticRest implements Scenes {

    private static final double HORIZON = 60;
    private static final double MILLIMETRE = 1e-3;

    /** Round-off as a share of the drop, as derived above. */
    private static final double ROUND_OFF = 1e-9;

    @Override
    public void run(Trial trial) {
        trial.variant("placed");
        rest(trial, 1, 0);
        trial.variant("dropped by 1 mm");
        rest(trial, 1, MILLIMETRE);
        trial.variant("three on each other");
        rest(trial, 3, 0);
    }

    private static void rest(Trial trial, int count, double drop) {
        WatchedPool pool = trial.ground(0.5, 1);
        List<RigidBody> boxes = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            boxes.add(pool.add(Solid.box(1, 1, 0.5, 1).at(0, 0.5 + i + drop)));
        }
        double released = count * Trial.GRAVITY * MILLIMETRE;
        double least = energy(pool);
        while (pool.time() < HORIZON) {
            pool.step();
            double now = energy(pool);
            trial.measure("energy regained", (now - least) / released, "of mg·1mm", ROUND_OFF);
            least = Math.min(least, now);
            for (int i = 0; i < count; i++) {
                double beyond = boxes.get(i).y() - 0.5 - i - drop;
                trial.measure("hop beyond the drop", beyond, "m", ROUND_OFF * MILLIMETRE);
            }
        }
    }

    private static double energy(WatchedPool pool) {
        return pool.energy();
    }
}
