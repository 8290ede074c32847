package rigibo.backend.law;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;

/** How fast the bodies of a pool are. */
final class Speeds {

    private Speeds() {}

    /** Bound of the speed of every point of every body, m/s. */
    static double fastest(Pool pool) {
        return pool.bodies().stream().mapToDouble(Speeds::of).max().orElse(0);
    }

    /** Sum of |m·v|, N·s. */
    static double momenta(Pool pool) {
        return pool.bodies().stream()
                .mapToDouble(body -> body.mass() * Math.hypot(body.velocityX(), body.velocityY()))
                .sum();
    }

    private static double of(RigidBody body) {
        double turning = Math.abs(body.angularVelocity()) * body.shape().boundingRadius();
        return Math.hypot(body.velocityX(), body.velocityY()) + turning;
    }
}
