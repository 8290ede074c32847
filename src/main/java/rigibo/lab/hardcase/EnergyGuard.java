package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.effect.Gravity;
import rigibo.backend.setup.BodyType;

import java.util.List;

/**
 * Compares the energy of a scene with that of its start and the work done on it. A limit per step
 * alone would allow a little more at every step.
 */
final class EnergyGuard {

    private final Gravity gravity;
    private final double start;
    private double mass;
    private double lowest = Double.POSITIVE_INFINITY;
    private double work;

    /**
     * Begins with the present energy.
     *
     * @param springs energy in springs, J
     */
    EnergyGuard(List<RigidBody> bodies, Gravity gravity, double springs) {
        this.gravity = gravity;
        start = energy(bodies) + springs;
    }

    /** Adds work done on the scene, J; negative if the scene did it. */
    void add(double joules) {
        work += joules;
    }

    /**
     * The energy beyond the start and the work, as a share of the energy that could have been
     * released: the motion at the start, and a fall to the lowest point that any body has reached.
     */
    double beyond(List<RigidBody> bodies, double springs) {
        double excess = energy(bodies) + springs - start - work;
        double could = start - mass * lowest + Math.max(0, work);
        return could > 0 ? Math.max(0, excess) / could : Math.max(0, excess);
    }

    /** The energy of motion and height, J. */
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

    /** The potential energy of a body's centre, J/kg; also records that of its lowest point. */
    private double height(RigidBody body) {
        double height = -gravity.x() * body.x() - gravity.y() * body.y();
        double pull = Math.hypot(gravity.x(), gravity.y());
        lowest = Math.min(lowest, height - pull * body.shape().boundingRadius());
        return height;
    }
}
