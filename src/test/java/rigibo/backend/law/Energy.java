package rigibo.backend.law;

import rigibo.backend.Joint;
import rigibo.backend.Pool;

/** The books of a pool's energy. */
final class Energy {

    private final Pool pool;
    private final double first;
    private double last;
    private double mostGained;
    private double mostOverFirst;

    Energy(Pool pool) {
        this.pool = pool;
        first = now();
        last = first;
    }

    /** Closes the books of a step; what is not a number stays in them. */
    void note() {
        double energy = now();
        mostGained = Math.max(mostGained, energy - last);
        mostOverFirst = Math.max(mostOverFirst, energy - first);
        last = energy;
    }

    /** Largest gain in one step as a share of the energy at the start. */
    double mostGainedShare() {
        return mostGained / first;
    }

    /** Most that there was more than at the start, as a share of that. */
    double mostOverFirstShare() {
        return mostOverFirst / first;
    }

    private double now() {
        return of(pool);
    }

    /** Energy of motion, height and springs, J. */
    static double of(Pool pool) {
        double springs = pool.joints().stream().mapToDouble(Joint::energy).sum();
        return pool.kineticEnergy() + pool.potentialEnergy() + springs;
    }
}
