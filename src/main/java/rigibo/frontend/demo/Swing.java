package rigibo.frontend.demo;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Length;
import rigibo.frontend.scene.Scene;

import java.util.OptionalDouble;

/**
 * A bob on a stiff rod that swings about the origin: the period that follows from its energy, and
 * the measured one. I is its inertia about the origin, L the distance from there to its middle.
 */
final class Swing {

    /** The formula of the period; M is the arithmetic-geometric mean. */
    static final String FORMULA = "2π√(L/g)/M(1, cos½θ)";

    /** Of the force that the pin bears, without the bob's own inertia. */
    static final String PULL = "≈ m·(g·cosθ + L·ω²)";

    /** Relative difference at which the arithmetic-geometric mean has converged. */
    private static final double MEAN_TOLERANCE = 1e-15;

    private static final int BISECTIONS = 50;

    private final RigidBody bob;
    private final double length;
    private int steps;
    private double lastAngle;
    private double lastRate;
    private double lastPull;

    /**
     * Times of the last passages below the pin to the left and to the right, s; NaN before the
     * first.
     */
    private final double[] passed = {Double.NaN, Double.NaN};

    private double measured = Double.NaN;
    private double pull;

    Swing(RigidBody bob, double length) {
        this.bob = bob;
        this.length = length;
        begin();
    }

    /** Discards the measurements. */
    void begin() {
        passed[0] = Double.NaN;
        passed[1] = Double.NaN;
        measured = Double.NaN;
        lastAngle = angle();
        lastRate = rate();
        lastPull = pullNow();
        pull = lastPull;
    }

    /** Angle from the vertical, rad, positive to the right. */
    private double angle() {
        return Angle.atan2(bob.x(), -bob.y());
    }

    private double rate() {
        double square = bob.x() * bob.x() + bob.y() * bob.y();
        return (bob.x() * bob.velocityY() - bob.y() * bob.velocityX()) / square;
    }

    /** I, kg·m². */
    private double inertia() {
        return bob.inertia() + bob.mass() * length * length;
    }

    /** E/(2·m·g·L): the pendulum swings to and fro below 1, and goes round above. */
    double share() {
        double rate = rate();
        double motion = inertia() * rate * rate / 2;
        double most = 2 * bob.mass() * Hang.G * length;
        return motion / most + (1 - Angle.cos(angle())) / 2;
    }

    /** The largest angle from the vertical, rad. */
    double amplitude() {
        return share() >= 1 ? Math.PI : 2 * Angle.asin(Math.sqrt(share()));
    }

    /**
     * The period of a mathematical pendulum, s. To and fro it takes 4·√(L/g)·K(k) with k =
     * sin(θ₀/2), and once round 2·√(L/g)·K(1/k)/k with k² = E/(2·m·g·L), where K(k) is π/(2·agm(1,
     * √(1 − k²))) (Abramowitz and Stegun, "Handbook of Mathematical Functions", 17.6.3).
     */
    double predicted() {
        double share = share();
        double small = 2 * Math.PI * Math.sqrt(inertia() / (bob.mass() * Hang.G * length));
        if (share < 1) {
            return small / mean(1, Math.sqrt(1 - share));
        }
        return small / 2 / (Math.sqrt(share) * mean(1, Math.sqrt(1 - 1 / share)));
    }

    /** Gauss's arithmetic-geometric mean. */
    private static double mean(double one, double other) {
        double a = one;
        double b = other;
        while (Math.abs(a - b) > MEAN_TOLERANCE * a) {
            double middle = (a + b) / 2;
            b = Math.sqrt(a * b);
            a = middle;
        }
        return a;
    }

    /** Measured time between the last two passages in one direction, s. */
    OptionalDouble measured() {
        return Double.isNaN(measured) ? OptionalDouble.empty() : OptionalDouble.of(measured);
    }

    /** Force that the pin must bear, N, as the mean over the last step. */
    double pull() {
        return pull;
    }

    /**
     * Force along the rod, m·(g·cos θ + L·θ̇²), and across it, m·g·sin θ·(I − m·L²)/I: the part of
     * the weight that turns the bob itself.
     */
    private double pullNow() {
        double rate = rate();
        double along = bob.mass() * (Hang.G * Angle.cos(angle()) + length * rate * rate);
        double across = bob.mass() * Hang.G * Angle.sin(angle()) * bob.inertia() / inertia();
        return Length.hypot(along, across);
    }

    void afterStep() {
        double angle = angle();
        double rate = rate();
        steps++;
        boolean isBelow = Math.abs(angle) + Math.abs(lastAngle) < Math.PI;
        if (isBelow && (lastAngle < 0) != (angle < 0)) {
            pass(angle < 0 ? 0 : 1, (steps - 1 + passage(angle, rate)) * Scene.STEP);
        }
        pull = (lastPull + pullNow()) / 2;
        lastPull = pullNow();
        lastAngle = angle;
        lastRate = rate;
    }

    private void pass(int way, double time) {
        if (!Double.isNaN(passed[way])) {
            measured = time - passed[way];
        }
        passed[way] = time;
    }

    /**
     * Time of the passage within the last step, 0 to 1: the zero of the cubic through both angles
     * and both rates. Its error is about 1e-8 of a step.
     */
    private double passage(double angle, double rate) {
        double low = 0;
        double high = 1;
        for (int i = 0; i < BISECTIONS; i++) {
            double t = (low + high) / 2;
            double left = 1 - t;
            double now =
                    left * left * (1 + 2 * t) * lastAngle
                            + left * left * t * lastRate * Scene.STEP
                            + t * t * (3 - 2 * t) * angle
                            - t * t * left * rate * Scene.STEP;
            if (now < 0 == lastAngle < 0) {
                low = t;
            } else {
                high = t;
            }
        }
        return (low + high) / 2;
    }
}
