package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/** Truth: what stands for a minute stands for an hour; nothing drifts and nothing grows. */
final class LongStack implements HardCase {

    private static final int COUNT = 20;
    private static final double MOST_LEAN = 5e-3;

    @Override
    public String row() {
        return "59/stack";
    }

    @Override
    public String title() {
        return "a stack of 20 boxes stands for an hour";
    }

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.pool(Surroundings.earth());
        pool.add(Surroundings.floor(0.5, 0));
        List<RigidBody> boxes = new ArrayList<>();
        for (int i = 0; i < COUNT; i++) {
            boxes.add(pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, i + 0.5)));
        }
        new Hour(trial, pool).run(() -> judge(trial, boxes));
        double limit = 2 * Trial.TOLERATED_OVERLAP;
        trial.measure("overlap after an hour", pool.overlapNow(), "width", limit, 6e-3);
    }

    private static void judge(Trial trial, List<RigidBody> boxes) {
        for (int i = 0; i < COUNT; i++) {
            RigidBody box = boxes.get(i);
            trial.measure("lean", Math.abs(box.x()), "m", MOST_LEAN);
            trial.measure("sinking", Math.abs(box.y() - i - 0.5) / (i + 1), "m a box", 6e-3);
        }
    }
}
