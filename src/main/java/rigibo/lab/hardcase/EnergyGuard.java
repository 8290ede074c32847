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
    private final double start;
    private double mass;
    private double lowest = Double.POSITIVE_INFINITY;
    private double work;

    /**
     * Begins with what there is now.
     *
     * @param springs energy in springs, J
     */
    EnergyGuard(List<RigidBody> bodies, Gravity gravity, double springs) {
        this.gravity = gravity;
        start = energy(bodies) + springs;
    }

    /** Adds work that was done to the scene, J; less than 0 where it was taken from it. */
    void add(double joules) {
        work += joules;
    }

    /**
     * Energy beyond the start and the work, as a share of what could be released by now: the motion
     * at the start, and a fall from there to the lowest point that anything has reached.
     */
    double beyond(List<RigidBody> bodies, double springs) {
        double excess = energy(bodies) + springs - start - work;
        double could = start - mass * lowest + Math.max(0, work);
        return could > 0 ? Math.max(0, excess) / could : Math.max(0, excess);
    }

    /** Energy of motion and height, J. */
    private double energy(List<RigidBody> bodies) {
        double sum = 0;
        mass = 0;
        for (RigidBody body : bodies) {
            if (body.type() == BodyType.DYNAMIC) {
                mass += body.mass();
                sum += body.kineticEnergy() + body.mass() * height(body);
            }
        }
        return sum;
    }

    /** Potential energy of a body's centre, J/kg; notes that of its lowest point. */
    private double height(RigidBody body) {
        double height = -gravity.x() * body.x() - gravity.y() * body.y();
        double pull = Math.hypot(gravity.x(), gravity.y());
        lowest = Math.min(lowest, height - pull * body.shape().boundingRadius());
        return height;
    }
}
