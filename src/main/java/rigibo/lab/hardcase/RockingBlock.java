package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Angle;
import rigibo.backend.geometry.Length;
import rigibo.lab.truth.Solid;

import java.util.SplittableRandom;

/**
 * A block rocks from corner to corner, e = 0, μ = 2. Truth: the angular momentum about the landing
 * corner is kept, so ω⁺/ω⁻ = 1 − (3/2)·sin²α with tan α = width/height (Housner, The behavior of
 * inverted pendulum structures during earthquakes, 1963, eq. 6). An impact multiplies the energy of
 * rocking by the square of that ratio; between impacts the energy is kept.
 */
final class RockingBlock implements Scenes {

    private static final int IMPACTS = 10;
    private static final double FRICTION = 2;
    private static final double PATIENCE = 60;

    /** The lift below which a corner is not judged, m. */
    private static final double LEAST_LIFT = 1e-3;

    private static final Limits LIMITS = Limits.of(0.01, 0.001);

    @Override
    public void run(Trial trial) {
        for (SplittableRandom random : trial.sampling().draws(4, 30)) {
            double height = 0.5 + 3 * random.nextDouble();
            double width = height * (0.15 + 0.35 * random.nextDouble());
            double start = (0.3 + 0.5 * random.nextDouble()) * Angle.atan2(width, height);
            trial.variant(width + " m × " + height + " m, from " + start + " rad");
            rock(trial, width, height, start);
        }
    }

    private static void rock(Trial trial, double width, double height, double start) {
        double half = Length.hypot(width, height) / 2;
        double alpha = Angle.atan2(width, height);
        WatchedPool pool = trial.ground(FRICTION, 0).withOverlapOfItsOwn();
        // Turned counter-clockwise about its lower left corner, which is at the origin.
        RigidBody block =
                pool.add(
                        Solid.box(width, height, FRICTION, 0)
                                .at(
                                        -half * Angle.sin(start - alpha),
                                        half * Angle.cos(start - alpha))
                                .angle(start));
        double truth = 1 - 1.5 * Math.pow(Math.sin(alpha), 2);
        double least = energyOfLift(LEAST_LIFT, width, height);
        double before = energy(block, height);
        for (int impact = 0; impact < IMPACTS && before > least; impact++) {
            double[] swing = swing(pool, block, height);
            trial.relativeError("energy between impacts", swing[0], before, "of it", LIMITS);
            if (swing[1] < least) {
                return;
            }
            double ratio = Math.sqrt(swing[1] / swing[0]);
            trial.relativeError("spin kept by an impact", ratio, truth, "of truth", LIMITS);
            before = swing[1];
        }
    }

    /** Steps until the block leans the other way; returns the energies about the impact. */
    private static double[] swing(WatchedPool pool, RigidBody block, double height) {
        double sign = Math.signum(block.angle());
        double before = energy(block, height);
        while (pool.time() < PATIENCE) {
            pool.step();
            double now = energy(block, height);
            if (block.angle() * sign <= 0) {
                return new double[] {before, now};
            }
            before = now;
        }
        return new double[] {before, 0};
    }

    /** Kinetic energy, and potential energy above that at rest, per weight: m. */
    private static double energy(RigidBody block, double height) {
        return block.y() - height / 2 + block.kineticEnergy() / (block.mass() * Trial.GRAVITY);
    }

    /** Energy per weight of the block at rest on a corner with the other at a height, m. */
    private static double energyOfLift(double lift, double width, double height) {
        double angle = Math.asin(lift / width);
        return (width * Math.sin(angle) + height * Math.cos(angle) - height) / 2;
    }
}
