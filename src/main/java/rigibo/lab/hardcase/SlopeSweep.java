package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Slope;

/**
 * Truth: a box on a slope rests while tan(angle) ≤ μ and slides with a = g(sin − μ·cos) beyond,
 * here 0.2° to either side and 10° above. The box is flat, so that it cannot tip at μ = 1.
 */
final class SlopeSweep implements HardCase {

    private static final double THICKNESS = 0.25;
    private static final double REST_HORIZON = 60;
    private static final double SLIDE_HORIZON = 4;

    @Override
    public String row() {
        return "26";
    }

    @Override
    public String title() {
        return "a box begins to slide at the angle of friction";
    }

    @Override
    public void run(Trial trial) {
        for (double friction : new double[] {0.1, 0.3, 0.6, 1}) {
            double degrees = Math.toDegrees(Math.atan(friction));
            trial.variant("mu " + friction + ", 0.2° below");
            rest(trial, friction, Math.toRadians(degrees - 0.2));
            trial.variant("mu " + friction + ", 0.2° above");
            slide(trial, friction, Math.toRadians(degrees + 0.2));
            trial.variant("mu " + friction + ", 10° above");
            slide(trial, friction, Math.toRadians(degrees + 10));
        }
    }

    private static RigidBody place(WatchedPool pool, double friction, Slope slope) {
        pool.add(slope.plank(Surroundings.matter(friction, 0)));
        BodyDefinition box =
                BodyDefinition.dynamic(Polygon.box(1, THICKNESS))
                        .material(Surroundings.matter(friction, 0));
        return pool.add(slope.place(box, THICKNESS / 2));
    }

    private static void rest(Trial trial, double friction, double angle) {
        Slope slope = new Slope(angle);
        WatchedPool pool = trial.pool(Surroundings.earth());
        RigidBody box = place(pool, friction, slope);
        pool.run(1);
        double start = slope.down(box.x(), box.y());
        pool.run(REST_HORIZON - 1);
        double creep = (slope.down(box.x(), box.y()) - start) / (REST_HORIZON - 1);
        trial.measure("creep", Math.abs(creep), "m/s", 1e-6, 1e-4);
    }

    private static void slide(Trial trial, double friction, double angle) {
        Slope slope = new Slope(angle);
        WatchedPool pool = trial.pool(Surroundings.earth());
        RigidBody box = place(pool, friction, slope);
        pool.run(1);
        double before = slope.down(box.velocityX(), box.velocityY());
        pool.run(SLIDE_HORIZON - 1);
        double after = slope.down(box.velocityX(), box.velocityY());
        double truth = Trial.GRAVITY * (Math.sin(angle) - friction * Math.cos(angle));
        double error = (after - before) / (SLIDE_HORIZON - 1) / truth - 1;
        trial.measure("acceleration", Math.abs(error), "of truth", 1e-4, 1e-2);
    }
}
