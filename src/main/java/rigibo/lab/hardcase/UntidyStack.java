package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Solid;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * Stacks of ten and twenty boxes set down carelessly: up to 5 mm to the side, up to 1 mm above
 * their support, e = 0. Truth: every centre is well inside every support below it, so the stack
 * stands where it was set down; after ten seconds it neither leans nor creeps.
 */
final class UntidyStack implements Scenes {

    private static final double SIDEWAYS = 5e-3;
    private static final double ABOVE = 1e-3;
    private static final double SETTLED = 10;
    private static final double HORIZON = 60;
    private static final double MOST_LEAN = 2e-3;

    @Override
    public void run(Trial trial) {
        int seeds = trial.sampling().count(3, 20);
        for (int i = 0; i < seeds; i++) {
            for (int count : new int[] {10, 20}) {
                trial.variant("seed " + trial.sampling().seed() + ", stack " + i + " of " + count);
                stand(trial, trial.sampling().random(i), count);
            }
        }
    }

    private static void stand(Trial trial, SplittableRandom random, int count) {
        WatchedPool pool = trial.ground(0.5, 0);
        List<RigidBody> boxes = new ArrayList<>();
        double y = -0.5;
        for (int i = 0; i < count; i++) {
            double x = SIDEWAYS * (2 * random.nextDouble() - 1);
            y += 1 + ABOVE * random.nextDouble();
            boxes.add(pool.add(Solid.box(1, 1).at(x, y)));
        }
        double[] start = boxes.stream().mapToDouble(RigidBody::x).toArray();
        pool.run(SETTLED);
        double[] settled = boxes.stream().mapToDouble(RigidBody::x).toArray();
        pool.run(HORIZON - SETTLED);
        for (int i = 0; i < count; i++) {
            double lean = Math.abs(boxes.get(i).x() - start[i]);
            trial.measure("lean", lean, "m", MOST_LEAN);
            double creep = Math.abs(boxes.get(i).x() - settled[i]) / (HORIZON - SETTLED);
            trial.measure("creep", creep, "m/s", 1e-6, 1e-5);
            double high = Math.abs(boxes.get(i).y() - i - 0.5) / (i + 1);
            trial.measure("height, per box", high, "m", 2e-3, 6e-3);
        }
    }
}
