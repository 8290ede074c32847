package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.CentralForce;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Field;
import rigibo.lab.truth.Solid;

/**
 * Truth: on a spring of ω a body that starts at (1, 0) with (0, ω) moves around the unit circle, at
 * the angle ωt. A planet with the semi-major axis 1 keeps v²/2 − GM/r = −GM/2, whatever its
 * eccentricity.
 */
final class SpringAndOrbit implements Scenes {

    /** One turn per second, of 60 steps. */
    private static final double OMEGA = 2 * Math.PI;

    private static final double HORIZON = 100;
    private static final double NEAREST = 0.5;

    @Override
    public void run(Trial trial) {
        trial.variant("spring");
        swing(trial);
        trial.variant("orbit");
        orbit(trial);
    }

    private static void swing(Trial trial) {
        double squared = OMEGA * OMEGA;
        Field spring = new Field(at -> at.accelerate(-squared * at.x, -squared * at.y));
        WatchedPool pool = trial.pool(Effects.of(spring));
        RigidBody ball = pool.add(Solid.disc(0.1).at(1, 0).velocity(0, OMEGA));
        pool.run(HORIZON);
        trial.measure("phase", Math.abs(Math.atan2(ball.y(), ball.x())), "rad", 1e-7, 1e-5);
        double speed = Math.hypot(ball.velocityX(), ball.velocityY()) / OMEGA;
        trial.measure("spring's energy", Math.abs(speed * speed - 1), "of E", 1e-9, 1e-6);
    }

    private static void orbit(Trial trial) {
        double strength = OMEGA * OMEGA;
        WatchedPool pool = trial.pool(Effects.of(new CentralForce(0, 0, strength, -2)));
        RigidBody planet =
                pool.add(
                        Solid.disc(0.01)
                                .at(NEAREST, 0)
                                .velocity(0, Math.sqrt(strength * (2 / NEAREST - 1))));
        double worst = 0;
        while (pool.time() < HORIZON) {
            pool.step();
            double v = Math.hypot(planet.velocityX(), planet.velocityY());
            double energy = v * v / 2 - strength / Math.hypot(planet.x(), planet.y());
            worst = Math.max(worst, Math.abs(energy / (-strength / 2) - 1));
        }
        trial.measure("orbit's energy", worst, "of E", 1e-7, 1e-4);
    }
}
