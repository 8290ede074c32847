package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.setup.Material;
import rigibo.lab.truth.Earth;
import rigibo.lab.truth.Solid;

/**
 * Truth with the torque c·N against rolling: m·d = F and I·d/r = c·m·g − F·r give the deceleration
 * d = ⅔·c·g/r; from v0 the disc stops after v0²/2d and never reverses.
 */
final class RollingToStop implements Scenes {

    private static final double RADIUS = 0.5;
    private static final double LEVER = 0.02;
    private static final double SPEED = 2;

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.pool(Earth.effects().with(new RollingResistance()));
        Material material = Solid.matter(0.5, 0).rollingResistance(LEVER);
        pool.add(Earth.floor(0.5, 0));
        RigidBody disc =
                pool.add(
                        Solid.disc(RADIUS)
                                .at(-5, RADIUS)
                                .velocity(SPEED, 0)
                                .spin(-SPEED / RADIUS)
                                .material(material));
        double braking = 2 * LEVER * Trial.GRAVITY / (3 * RADIUS);
        pool.run(1);
        double early = disc.velocityX();
        pool.run(4);
        double late = disc.velocityX();
        trial.relativeError("deceleration", (early - late) / 4, braking, "of truth", 1e-4, 1e-2);
        double reverse = 0;
        while (pool.time() < 2 * SPEED / braking) {
            pool.step();
            reverse = Math.max(reverse, -disc.velocityX());
        }
        double way = SPEED * SPEED / (2 * braking);
        trial.relativeError("way", disc.x() + 5, way, "of truth", 1e-4, 1e-2);
        trial.measure("backwards", reverse, "m/s", 1e-6);
        trial.measure("speed at the end", Math.abs(disc.velocityX()), "m/s", 1e-6);
    }
}
