package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Bounces;
import rigibo.lab.truth.Solid;

/**
 * Truth: infinitely many bounces are over at T = t1(1 + e)/(1 − e), 5.747 s for H = 2 and e = 0.8.
 * A run shows only the step in which the ball came to rest. The error is the distance of T from
 * that step; 25 phases of T within a step make it an error in time.
 */
final class Zeno implements Scenes {

    private static final double RADIUS = 0.25;
    private static final double HEIGHT = 2;
    private static final int PHASES = 25;

    /** A negligible speed, m/s: at e = 0.8 a rebound of 0.1 mm/s leaves 0.1 ms of bounces. */
    private static final double NO_SPEED = 1e-4;

    @Override
    public void run(Trial trial) {
        for (double e : new double[] {0.8, 0.5}) {
            for (double vx : new double[] {0, 1}) {
                for (int phase = 0; phase < PHASES; phase++) {
                    trial.variant("e " + e + ", vx " + vx + ", phase " + phase);
                    bounce(trial, e, vx, phase);
                }
            }
        }
    }

    private static void bounce(Trial trial, double e, double vx, int phase) {
        double stretch = (1 + e) / (1 - e);
        double fall = Math.sqrt(2 * HEIGHT / Trial.GRAVITY) + phase * Trial.DT / PHASES / stretch;
        Bounces truth = new Bounces(Bounces.heightOfFall(fall), e);
        WatchedPool pool = trial.ground(0, e);
        RigidBody ball =
                pool.add(
                        Solid.disc(RADIUS, 0, e)
                                .at(0, RADIUS + Bounces.heightOfFall(fall))
                                .velocity(vx, 0));
        double lastMotion = 0;
        while (pool.time() < truth.restTime() + 1) {
            int impacts = pool.step().impacts();
            int most = trial.preset().accuracy().maxImpactsPerPair();
            trial.measure("impacts of a step beyond K", impacts - most, "impacts", 0);
            if (Math.abs(ball.velocityY()) > NO_SPEED) {
                lastMotion = pool.time();
            }
        }
        double early = truth.restTime() - (lastMotion + Trial.DT);
        double late = lastMotion - truth.restTime();
        trial.measure("time of rest", Math.max(0, Math.max(early, late)), "s", 1e-3, 20e-3);
        trial.measure("sideways speed", Math.abs(ball.velocityX() - vx), "m/s", 1e-9);
        double off = Math.abs(ball.y() - RADIUS);
        trial.measure("height at rest", off, "m", 2 * Trial.TOLERATED_OVERLAP * 2 * RADIUS);
    }
}
