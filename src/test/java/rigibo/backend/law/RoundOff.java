package rigibo.backend.law;

import rigibo.backend.Pool;
import rigibo.backend.RigidBody;

/**
 * How much doubles may change sums over the bodies of a pool. Every impact rounds the velocities of
 * two bodies, each by half a unit in the last place, and every step the places that angular
 * momentum is measured from: an error is at most their number times the unit in the last place of
 * the largest term that a sum has had.
 */
final class RoundOff {

    /** Relative distance of neighbouring doubles. */
    static final double UNIT = Math.ulp(1.0);

    /** Roundings of one impact: the arms, the rows, the two impulses, the six velocities. */
    private static final int PER_EVENT = 16;

    private double events = 1;

    /** Largest Σ|m·v| up to now, N·s. */
    private double speeds;

    /** Largest Σ(|m·v|·|r| + |I·ω|) up to now, kg·m²/s. */
    private double spins;

    /** Takes note of a pool whose last step had a number of impacts. */
    void note(Pool pool, int impacts) {
        events += impacts + 1;
        double linear = 0;
        double angular = 0;
        for (RigidBody body : pool.bodies()) {
            double momentum = body.mass() * Math.hypot(body.velocityX(), body.velocityY());
            linear += momentum;
            angular += momentum * Math.hypot(body.x(), body.y());
            angular += Math.abs(body.angularMomentum());
        }
        speeds = Math.max(speeds, linear);
        spins = Math.max(spins, angular);
    }

    /** N·s. */
    double ofMomentum() {
        return PER_EVENT * events * UNIT * speeds;
    }

    /** kg·m²/s. */
    double ofAngularMomentum() {
        return PER_EVENT * events * UNIT * spins;
    }
}
