package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/**
 * Bodies of e = 1 on a floor of e = 1: placed, dropped by 1 mm, and three on each other. Truth:
 * energy never rises, so no hop is ever higher than the drop. Heights and energies are compared
 * with one metre and the energy of lifting the scene by that.
 */
final class ElasticRest implements HardCase {

    private static final double HORIZON = 60;
    private static final double MILLIMETRE = 1e-3;

    @Override
    public String row() {
        return "25";
    }

    @Override
    public String title() {
        return "perfectly elastic bodies at rest do not begin to hop";
    }

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
        WatchedPool pool = trial.pool(Surroundings.earth());
        pool.add(Surroundings.floor(0.5, 1));
        List<RigidBody> boxes = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            boxes.add(
                    pool.add(
                            BodyDefinition.dynamic(Polygon.box(1, 1))
                                    .at(0, 0.5 + i + drop)
                                    .material(Surroundings.matter(0.5, 1))));
        }
        double lift = count * Trial.GRAVITY;
        double least = energy(pool);
        while (pool.time() < HORIZON) {
            pool.step();
            double now = energy(pool);
            trial.measure("energy regained", (now - least) / lift, "of mg·1m", 1e-6, 1e-3);
            least = Math.min(least, now);
            for (int i = 0; i < count; i++) {
                double hop = boxes.get(i).y() - 0.5 - i;
                trial.measure("hop", hop, "m", MILLIMETRE * (1 + 1e-9));
            }
        }
    }

    private static double energy(WatchedPool pool) {
        return pool.pool().kineticEnergy() + pool.pool().potentialEnergy();
    }
}
