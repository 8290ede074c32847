package rigibo.lab.hardcase;

import rigibo.backend.geometry.Angle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Slope;
import rigibo.lab.truth.Solid;

/**
 * Truth: a box on a slope rests while tan(angle) ≤ μ and slides with a = g(sin − μ·cos) beyond
 * that. Tried are 0.2° to either side and 10° above. The box is flat, so that it cannot tip at μ =
 * 1.
 */
final class SlopeSweep implements Scenes {

    private static final double THICKNESS = 0.25;
    private static final double REST_HORIZON = 60;
    private static final double SLIDE_HORIZON = 4;

    @Override
    public void run(Trial trial) {
        for (double friction : new double[] {0.1, 0.3, 0.6, 1}) {
            double degrees = Math.toDegrees(Angle.atan2(friction, 1));
            trial.variant("mu " + friction + ", 0.2° below");
            rest(trial, friction, Math.toRadians(degrees - 0.2));
            trial.variant("mu " + friction + ", 0.2° above");
            slide(trial, friction, Math.toRadians(degrees + 0.2));
            trial.variant("mu " + friction + ", 10° above");
            slide(trial, friction, Math.toRadians(degrees + 10));
        }
    }

    private static Descent place(WatchedPool pool, double friction, double angle) {
        Slope slope = new Slope(angle);
        BodyDefinition box = Solid.box(1, THICKNESS, friction, 0);
        return new Descent(pool, slope, slope.place(box, THICKNESS / 2));
    }

    private static void rest(Trial trial, double friction, double angle) {
        WatchedPool pool = trial.earth();
        Descent box = place(pool, friction, angle);
        pool.run(1);
        double start = box.place();
        pool.run(REST_HORIZON - 1);
        double creep = (box.place() - start) / (REST_HORIZON - 1);
        trial.measure("creep", Math.abs(creep), "m/s", 1e-6, 1e-4);
    }

    private static void slide(Trial trial, double friction, double angle) {
        WatchedPool pool = trial.earth();
        Descent box = place(pool, friction, angle);
        pool.run(1);
        double before = box.speed();
        pool.run(SLIDE_HORIZON - 1);
        double after = box.speed();
        double truth = Trial.GRAVITY * (Math.sin(angle) - friction * Math.cos(angle));
        double error = (after - before) / (SLIDE_HORIZON - 1) / truth - 1;
        trial.measure("acceleration", Math.abs(error), "of truth", 1e-4, 1e-2);
    }
}
