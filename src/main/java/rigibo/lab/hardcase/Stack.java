package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Earth;

import java.util.ArrayList;
import java.util.List;

/**
 * Truth: N boxes on each other stand for ever at the heights i + ½; the contact below box i carries
 * (N − i)·m·g·dt in every step. Sleep is off. The load's limits are those of a single box.
 */
record Stack(int count) implements Scenes {

    private static final double HORIZON = 60;
    private static final double MILLIMETRE = 1e-3;
    private static final int STEPS_WEIGHED = 60;

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.earth();
        List<RigidBody> bodies = new ArrayList<>();
        bodies.add(pool.add(Earth.floor(0.5, 0)));
        bodies.addAll(pool.stack(count));
        pool.run(HORIZON - STEPS_WEIGHED * Trial.DT);
        double[] load = new double[count];
        for (int step = 0; step < STEPS_WEIGHED; step++) {
            pool.step();
            for (int i = 0; i < count; i++) {
                load[i] += pool.impulseBetween(bodies.get(i), bodies.get(i + 1));
            }
        }
        judge(trial, pool, bodies);
        double unit = bodies.get(1).mass() * Trial.GRAVITY * Trial.DT * STEPS_WEIGHED;
        for (int i = 0; i < count; i++) {
            trial.relativeError(
                    "load on a contact", load[i], (count - i) * unit, "of truth", 1e-6, 1e-2);
        }
    }

    private void judge(Trial trial, WatchedPool pool, List<RigidBody> bodies) {
        for (int i = 1; i <= count; i++) {
            RigidBody box = bodies.get(i);
            double lean = Math.abs(box.x());
            if (count > 20) {
                report(trial, lean, box.y(), i);
            } else {
                trial.measure("lean", lean, "m", 2 * MILLIMETRE);
            }
            trial.measure("sinking per box", (i - 0.5 - box.y()) / i, "m", 6 * MILLIMETRE);
        }
        double limit = 2 * Trial.TOLERATED_OVERLAP;
        trial.measure("overlap", pool.deepestShare(), "width", limit, 6 * MILLIMETRE);
    }

    /** A box stands on the one below while its centre is above it. */
    private static void report(Trial trial, double lean, double y, int i) {
        trial.report("lean", lean, "m");
        trial.require("every box is on its own storey", y > i - 1 && lean < 0.5);
    }

    /** Truth: what stands for a minute stands for an hour; nothing drifts and nothing grows. */
    static void standForAnHour(Trial trial) {
        WatchedPool pool = trial.ground(0.5, 0);
        List<RigidBody> boxes = pool.stack(20);
        new Hour(trial, pool).run(() -> judgeHour(trial, boxes));
        double limit = 2 * Trial.TOLERATED_OVERLAP;
        trial.measure("overlap after an hour", pool.overlapNow(), "width", limit, 6e-3);
    }

    private static void judgeHour(Trial trial, List<RigidBody> boxes) {
        for (int i = 0; i < boxes.size(); i++) {
            RigidBody box = boxes.get(i);
            trial.measure("lean", Math.abs(box.x()), "m", 5 * MILLIMETRE);
            trial.measure("sinking", Math.abs(box.y() - i - 0.5) / (i + 1), "m a box", 6e-3);
        }
    }
}
