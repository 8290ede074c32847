package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/**
 * Truth: N boxes on each other stand for ever at the heights i + ½; the contact below box i carries
 * (N − i)·m·g·dt in every step. Sleep is off. The load's limits are those of a single box.
 */
final class Stack implements HardCase {

    private static final double HORIZON = 60;
    private static final double MILLIMETRE = 1e-3;
    private static final int STEPS_WEIGHED = 60;

    private final int count;

    Stack(int count) {
        this.count = count;
    }

    @Override
    public String row() {
        return "20/" + count;
    }

    @Override
    public String title() {
        return "a stack of " + count + " boxes stands upright";
    }

    /** Fifty boxes are promised from FINE on. */
    @Override
    public Preset fastest() {
        return count > 20 ? Preset.FINE : Preset.DRAFT;
    }

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.pool(Surroundings.earth());
        List<RigidBody> bodies = new ArrayList<>();
        bodies.add(pool.add(Surroundings.floor(0.5, 0)));
        for (int i = 0; i < count; i++) {
            bodies.add(pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(0, i + 0.5)));
        }
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
            double error = Math.abs(load[i] / ((count - i) * unit) - 1);
            trial.measure("load on a contact", error, "of truth", 1e-6, 1e-2);
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
}
