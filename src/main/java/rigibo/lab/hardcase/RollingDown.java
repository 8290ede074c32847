package rigibo.lab.hardcase;

import rigibo.backend.geometry.Angle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Slope;
import rigibo.lab.truth.Solid;

/**
 * Truth: a disc that does not slip rolls down with a = g·sin b/(1 + I/mr²) = ⅔·g·sin b if μ ≥
 * tan(b)/3, and rω equals v at every moment.
 */
final class RollingDown implements Scenes {

    private static final double RADIUS = 0.5;
    private static final double HORIZON = 5;

    @Override
    public void run(Trial trial) {
        for (double degrees : new double[] {5, 15, 30, 45}) {
            for (double share : new double[] {1.2, 3}) {
                double b = Math.toRadians(degrees);
                double friction = share * Angle.sin(b) / Angle.cos(b) / 3;
                trial.variant(degrees + "°, mu " + share + " of the least");
                roll(trial, b, friction);
            }
        }
    }

    private static void roll(Trial trial, double b, double friction) {
        Slope slope = new Slope(b);
        WatchedPool pool = trial.earth();
        BodyDefinition disc = slope.place(Solid.disc(RADIUS, friction, 0), RADIUS);
        Descent descent = new Descent(pool, slope, disc);
        double slip = 0;
        while (pool.time() < HORIZON - Trial.DT / 2) {
            pool.step();
            double rim = RADIUS * descent.body.angularVelocity();
            slip = Math.max(slip, Math.abs(descent.speed() + rim));
        }
        double t = pool.time();
        double a = 2 * Trial.GRAVITY * Math.sin(b) / 3;
        trial.relativeError("acceleration", descent.speed(), a * t, "of truth", 1e-5, 5e-3);
        trial.relativeError("way", descent.way(), a * t * t / 2, "of truth", 1e-5, 5e-3);
        trial.measure("slip", slip, "m/s", 1e-6);
    }
}
