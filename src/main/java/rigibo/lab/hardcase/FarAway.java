package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Sleep;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;

/**
 * Truth: the laws do not depend on the origin. A stepped pyramid of 5 + 3 + 1 boxes, dropped by 1
 * cm a storey, settles equally at 0, 1e7 and 1e9 m, except for the spacing of doubles there (1.9e-9
 * and 1.2e-7 m), and falls asleep in the same step.
 */
final class FarAway implements Scenes {

    private static final int STEPS = 300;
    private static final int[] STOREYS = {5, 3, 1};

    @Override
    public void run(Trial trial) {
        trial.variant("at the origin");
        Settling truth = new Settling(trial, 0);
        trial.measure("awake in the end", truth.asleepAt < 0 ? 1 : 0, "pyramids", 0);
        for (double far : new double[] {1e7, 1e9}) {
            trial.variant("at " + far + " m");
            Settling settling = new Settling(trial, far);
            double most = 0;
            for (int i = 0; i < truth.path.size(); i++) {
                most = Math.max(most, Math.abs(settling.path.get(i) - truth.path.get(i)));
            }
            String name = "difference of paths at " + far + " m";
            trial.measure(name, most, "m", far > 1e8 ? 1e-3 : 1e-6);
            int later = Math.abs(settling.asleepAt - truth.asleepAt);
            trial.measure("asleep so many steps apart", later, "steps", 0);
        }
    }

    /** One run: all paths relative to the origin, and the step in which all were asleep. */
    private static final class Settling {
        final List<Double> path = new ArrayList<>();
        int asleepAt = -1;

        Settling(Trial trial, double far) {
            WatchedPool pool = trial.pool(Earth.effects().with(new Sleep()));
            pool.add(Solid.fixed(2e6, 2).at(far, -1));
            List<RigidBody> boxes = new ArrayList<>();
            for (int storey = 0; storey < STOREYS.length; storey++) {
                for (int i = 0; i < STOREYS[storey]; i++) {
                    double x = far + 1.25 * (i - (STOREYS[storey] - 1) / 2.0);
                    double y = storey + 0.5 + 0.01 * (storey + 1);
                    boxes.add(pool.add(Solid.box(1, 1).at(x, y)));
                }
            }
            for (int step = 0; step < STEPS; step++) {
                pool.step();
                boolean isAsleep = boxes.stream().noneMatch(RigidBody::isAwake);
                asleepAt = isAsleep && asleepAt < 0 ? step : asleepAt;
                for (RigidBody box : boxes) {
                    path.add(box.x() - far);
                    path.add(box.y());
                }
            }
        }
    }
}
