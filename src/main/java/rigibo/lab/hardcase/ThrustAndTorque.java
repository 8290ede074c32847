package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.Thrust;
import rigibo.lab.truth.Solid;

/**
 * Truth for a torque τ and a force F with the constant lever r: ω = τt/I, θ = τt²/2I, v = Ft/m, ω =
 * (r × F)t/I. Box of 1 × 2 at density 1: m = 2, I = m(w² + h²)/12 = 5/6.
 */
final class ThrustAndTorque implements Scenes {

    private static final double MASS = 2;
    private static final double INERTIA = 5.0 / 6;
    private static final double HORIZON = 2;
    private static final double LIMIT = 1e-12;

    @Override
    public void run(Trial trial) {
        trial.variant("torque");
        turn(trial, 3);
        trial.variant("force off the centre");
        push(trial, 3, -2, 0.4, 0.7);
    }

    private static RigidBody box(WatchedPool pool) {
        return pool.add(Solid.box(1, 2));
    }

    private static void turn(Trial trial, double torque) {
        WatchedPool pool = trial.pool(Effects.of(new Rotation(), new Thrust()));
        RigidBody box = box(pool);
        for (int i = 1; i <= Math.round(HORIZON / Trial.DT); i++) {
            box.applyTorque(torque);
            pool.step();
            double t = i * Trial.DT;
            double spin = torque * t / INERTIA;
            trial.relativeError("spin", box.angularVelocity(), spin, "relative", LIMIT);
            trial.relativeError("angle", box.angle(), spin * t / 2, "relative", LIMIT);
        }
    }

    private static void push(Trial trial, double fx, double fy, double rx, double ry) {
        WatchedPool pool = trial.pool(Effects.of(new Rotation(), new Thrust()));
        RigidBody box = box(pool);
        for (int i = 1; i <= Math.round(HORIZON / Trial.DT); i++) {
            box.applyForce(fx, fy, box.x() + rx, box.y() + ry);
            pool.step();
            double t = i * Trial.DT;
            double off =
                    Math.hypot(box.velocityX() - fx * t / MASS, box.velocityY() - fy * t / MASS);
            double speed = Math.hypot(fx, fy) * t / MASS;
            trial.measure("velocity", off / speed, "relative", LIMIT);
            double spin = (rx * fy - ry * fx) * t / INERTIA;
            trial.relativeError("spin", box.angularVelocity(), spin, "relative", LIMIT);
        }
    }
}
