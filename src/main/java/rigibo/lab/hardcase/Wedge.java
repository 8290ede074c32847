package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Angle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Solid;

/**
 * Truth: a smooth disc between two faces, each at the angle a from the vertical, is held by N =
 * mg/(2 sin a) at each: 5.74 mg at 5°, 14.3 mg at 2°.
 */
final class Wedge implements Scenes {

    private static final double RADIUS = 0.5;
    private static final double LENGTH = 40;
    private static final int STEPS_WEIGHED = 60;

    @Override
    public void run(Trial trial) {
        for (double degrees : new double[] {30, 5, 2}) {
            trial.variant("half-angle " + degrees + "°");
            hold(trial, Math.toRadians(degrees));
        }
    }

    private static void hold(Trial trial, double a) {
        WatchedPool pool = trial.earth();
        RigidBody right = pool.add(face(a, 1));
        RigidBody left = pool.add(face(a, -1));
        RigidBody disc = pool.add(Solid.disc(RADIUS, 0, 0).at(0, RADIUS / Angle.sin(a)));
        pool.run(2);
        double onRight = 0;
        double onLeft = 0;
        for (int i = 0; i < STEPS_WEIGHED; i++) {
            pool.step();
            onRight += pool.impulseBetween(disc, right);
            onLeft += pool.impulseBetween(disc, left);
        }
        double weight = disc.mass() * Trial.GRAVITY * Trial.DT * STEPS_WEIGHED;
        double truth = weight / (2 * Math.sin(a));
        trial.relativeError("force, right", onRight, truth, "of N", 1e-4, 2e-2);
        trial.relativeError("force, left", onLeft, truth, "of N", 1e-4, 2e-2);
        double limit = 2 * Trial.TOLERATED_OVERLAP;
        trial.measure("overlap at rest", pool.overlapNow(), "width", limit);
    }

    /** A plank whose inner face starts at the origin and leans to a side, −1 or 1. */
    private static BodyDefinition face(double a, int side) {
        double alongX = side * Angle.sin(a);
        double alongY = Angle.cos(a);
        double outX = side * Angle.cos(a);
        double outY = -Angle.sin(a);
        return Solid.fixed(LENGTH, 2, 0, 0)
                .at(alongX * LENGTH / 2 + outX, alongY * LENGTH / 2 + outY)
                .angle(Angle.atan2(alongY, alongX));
    }
}
