package rigibo.frontend.scene.accuracy;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;
import rigibo.backend.setup.BodyType;

/**
 * The mechanical energy of a pool by kinds, J.
 *
 * @param potential in the declared gravity, 0 at the world's origin; negative below it
 * @param translational of the motion of the centres of mass, 0 or more
 * @param rotational about them, 0 or more
 */
public record Energy(double potential, double translational, double rotational) {

    /** The present energy of a pool. */
    public static Energy of(Pool pool) {
        double translational = 0;
        double rotational = 0;
        for (RigidBody body : pool.bodies()) {
            if (body.type() == BodyType.DYNAMIC) {
                double vx = body.velocityX();
                double vy = body.velocityY();
                double along = body.mass() * (vx * vx + vy * vy) / 2;
                translational += along;
                // Energy of a body apart from its motion; rounding must not make it negative.
                rotational += Math.max(0, body.kineticEnergy() - along);
            }
        }
        return new Energy(pool.potentialEnergy(), translational, rotational);
    }

    /** All of it, J. */
    public double total() {
        return potential + translational + rotational;
    }
}
