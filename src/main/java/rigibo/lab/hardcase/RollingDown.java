package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;
import rigibo.lab.truth.Slope;

/**
 * Truth: a disc that does not slip rolls down with a = g·sin b/(1 + I/mr²) = ⅔·g·sin b, where μ ≥
 * tan(b)/3, and rω equals v at every moment.
 */
final class RollingDown implements HardCase {

    private static final double RADIUS = 0.5;
    private static final double HORIZON = 5;

    @Override
    public String row() {
        return "34";
    }

    @Override
    public String title() {
        return "a disc rolls down a slope without slipping";
    }

    @Override
    public void run(Trial trial) {
        for (double degrees : new double[] {5, 15, 30, 45}) {
            for (double share : new double[] {1.2, 3}) {
                double b = Math.toRadians(degrees);
                double friction = share * Math.tan(b) / 3;
                trial.variant(degrees + "°, mu " + share + " of the least");
                roll(trial, b, friction);
            }
        }
    }

    private static void roll(Trial trial, double b, double friction) {
        Slope slope = new Slope(b);
        WatchedPool pool = trial.pool(Surroundings.earth());
        pool.add(slope.plank(Surroundings.matter(friction, 0)));
        BodyDefinition definition =
                BodyDefinition.dynamic(new Circle(RADIUS))
                        .material(Surroundings.matter(friction, 0));
        RigidBody disc = pool.add(slope.place(definition, RADIUS));
        double startX = disc.x();
        double startY = disc.y();
        double slip = 0;
        while (pool.time() < HORIZON - Trial.DT / 2) {
            pool.step();
            double v = slope.down(disc.velocityX(), disc.velocityY());
            slip = Math.max(slip, Math.abs(v + RADIUS * disc.angularVelocity()));
        }
        double t = pool.time();
        double a = 2 * Trial.GRAVITY * Math.sin(b) / 3;
        double v = slope.down(disc.velocityX(), disc.velocityY());
        double way = slope.down(disc.x() - startX, disc.y() - startY);
        trial.measure("acceleration", Math.abs(v / (a * t) - 1), "of truth", 1e-5, 5e-3);
        trial.measure("way", Math.abs(way / (a * t * t / 2) - 1), "of truth", 1e-5, 5e-3);
        trial.measure("slip", slip, "m/s", 1e-6);
    }
}
