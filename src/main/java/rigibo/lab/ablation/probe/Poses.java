package rigibo.lab.ablation.probe;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;

import java.util.List;

/** The places and velocities of all moving bodies of a pool, to restore them. */
final class Poses {

    private final List<RigidBody> bodies;
    private final double[][] poses;

    Poses(Pool pool) {
        bodies = pool.bodies().stream().filter(body -> body.type() == BodyType.DYNAMIC).toList();
        poses = bodies.stream().map(Poses::of).toArray(double[][]::new);
    }

    private static double[] of(RigidBody body) {
        return new double[] {
            body.x(),
            body.y(),
            body.angle(),
            body.velocityX(),
            body.velocityY(),
            body.angularVelocity()
        };
    }

    /** Puts every body back and wakes it. */
    void restore() {
        for (int i = 0; i < poses.length; i++) {
            double[] pose = poses[i];
            RigidBody body = bodies.get(i);
            body.moveTo(pose[0], pose[1], pose[2]);
            body.velocity(pose[3], pose[4]);
            body.spin(pose[5]);
            body.wake();
        }
    }
}
