package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.BodyType;

import java.util.List;

/**
 * Holds a scene to the energy it began with and the work that is done to it: a limit per step alone
 * lets a little through at every step.
 */
final class EnergyGuard {

    private final Gravity gravity;
    private final double floorY;
    private final double start;
    private double work;

    /**
     * Begins with what there is now.
     *
     * @param floorY height to which all that is above can fall, m
     */
    EnergyGuard(List<RigidBody> bodies, Gravity gravity, double floorY) {
        this.gravity = gravity;
        this.floorY = floorY;
        start = energy(bodies);
    }

    /** Adds work that was done to the scene, J; less than 0 where it was taken from it. */
    void add(double joules) {
        work += joules;
    }

    /** Energy beyond the start and the work, as a share of what could be released by now. */
    double beyond(List<RigidBody> bodies) {
        double excess = energy(bodies) - start - work;
        double could = start + Math.max(0, work);
        return could > 0 ? Math.max(0, excess) / could : Math.max(0, excess);
    }

    /** Energy of motion and of height over the floor, J. */
    double energy(List<RigidBody> bodies) {
        double sum = 0;
        for (RigidBody body : bodies) {
            if (body.type() == BodyType.DYNAMIC) {
                double fall = gravity.x() * body.x() + gravity.y() * (body.y() - floorY);
                sum += body.kineticEnergy() - body.mass() * fall;
            }
        }
        return sum;
    }
}
