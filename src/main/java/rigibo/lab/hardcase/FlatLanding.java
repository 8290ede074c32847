package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Bounces;
import rigibo.lab.truth.Solid;

/**
 * Truth: a box that lands flat with e = 1 meets the floor at both corners at once. By symmetry it
 * does not turn, and it rebounds to its height, on a pedestal narrower than itself as well. One
 * impulse at each corner in turn would overshoot.
 */
final class FlatLanding implements Scenes {

    private static final double HEIGHT = 2;
    private static final int PHASES = 5;
    private static final int APEXES = 10;

    @Override
    public void run(Trial trial) {
        for (double width : new double[] {20, 0.75}) {
            for (int phase = 0; phase < PHASES; phase++) {
                trial.variant("ground of " + width + " m, phase " + phase);
                double fall = Math.sqrt(2 * HEIGHT / Trial.GRAVITY) + phase * Trial.DT / PHASES;
                drop(trial, width, fall);
            }
        }
    }

    private static void drop(Trial trial, double width, double fall) {
        WatchedPool pool = trial.earth();
        pool.add(Solid.fixed(width, 1, 0.5, 1).at(0, -0.5));
        Bounces truth = new Bounces(Bounces.heightOfFall(fall), 1);
        RigidBody box = pool.add(Solid.box(1, 1, 0.5, 1).at(0, 0.5 + Bounces.heightOfFall(fall)));
        double leeway = trial.preset() == Preset.EXACT ? 1e-5 : 1e-2;
        while (pool.time() < truth.impactTime(APEXES + 1) - 2 * leeway - Trial.DT) {
            pool.step();
            trial.measure("spin", Math.abs(box.angularVelocity()), "rad/s", 1e-9);
            double error =
                    truth.apexError(
                            pool.time(), leeway, Bounces.apexOf(box.y() - 0.5, box.velocityY()));
            trial.measure("apex", error, "of H", 1e-6, 5e-3);
        }
    }
}
