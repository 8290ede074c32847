package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Solid;

/**
 * Truth: from v0 = 10 with μ = ½ a box slides d = v0²/2μg = 10.194 m in t = v0/μg = 2.039 s, and
 * does not reverse. It stopped v/μg after its last moving step, whose speed is v.
 */
final class SlideToStop implements Scenes {

    private static final double SPEED = 10;
    private static final double FRICTION = 0.5;
    private static final double THICKNESS = 0.25;

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.ground(FRICTION, 0);
        RigidBody box =
                pool.add(
                        Solid.box(1, THICKNESS, FRICTION, 0)
                                .at(-5, THICKNESS / 2)
                                .velocity(SPEED, 0));
        double braking = FRICTION * Trial.GRAVITY;
        double stop = 0;
        double reverse = 0;
        while (pool.time() < 2 * SPEED / braking) {
            pool.step();
            double v = box.velocityX();
            stop = v > braking * Trial.DT ? pool.time() + v / braking : stop;
            reverse = Math.max(reverse, -v);
        }
        double way = SPEED * SPEED / (2 * braking);
        trial.relativeError("way", box.x() + 5, way, "of d", 1e-5, 5e-3);
        trial.relativeError("time", stop, SPEED / braking, "of t", 1e-5, 5e-3);
        trial.measure("backwards", reverse, "m/s", 1e-6);
    }
}
