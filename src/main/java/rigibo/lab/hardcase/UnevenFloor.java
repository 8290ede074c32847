package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

/**
 * A box across the gap of 1 mm between two floor boxes, level and with gravity tilted by 5° (below
 * atan μ), and a box that bridges a step. Truth: both rest. The second one stands on its lower left
 * corner and on the step's edge. With its centre 0.1 m left of the edge the span is 0.6 m, and its
 * tilt is atan(step/span), up to a term of second order from the corner's own height.
 */
final class UnevenFloor implements Scenes {

    private static final double STEP = 5e-4;
    private static final double SPAN = 0.6;
    private static final double HORIZON = 10;

    @Override
    public void run(Trial trial) {
        trial.variant("level, gap of 1 mm");
        bridge(trial, 0, 1e-3, 0, 0);
        trial.variant("tipped by 5°, gap of 1 mm");
        bridge(trial, Math.toRadians(5), 1e-3, 0, 0);
        trial.variant("step of 0.5 mm");
        bridge(trial, 0, 0, STEP, StrictMath.atan(STEP / SPAN));
    }

    private static void bridge(Trial trial, double tip, double gap, double step, double tilt) {
        double gx = -Trial.GRAVITY * Math.sin(tip);
        double gy = -Trial.GRAVITY * Math.cos(tip);
        WatchedPool pool = trial.pool(Earth.effects().with(new Gravity(gx, gy)));
        BodyDefinition slab = Solid.fixed(4, 1);
        pool.add(slab.at(-2 - gap / 2, -0.5));
        pool.add(slab.at(2 + gap / 2, -0.5 + step));
        double x = step > 0 ? 0.5 - SPAN : 0;
        RigidBody box = pool.add(Solid.box(1, 1).at(x, 0.5 + step).angle(tilt));
        pool.run(1);
        double path = 0;
        while (pool.time() < HORIZON + 1) {
            double beforeX = box.x();
            double beforeY = box.y();
            pool.step();
            path += Math.hypot(box.x() - beforeX, box.y() - beforeY);
            trial.measure("tilt", Math.abs(box.angle() - tilt), "rad", 1e-4);
        }
        trial.measure("path in 10 s", path, "m", 1e-3);
    }
}
