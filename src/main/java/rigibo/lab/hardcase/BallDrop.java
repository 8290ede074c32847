package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.child.Work;
import rigibo.lab.truth.Bounces;
import rigibo.lab.truth.Solid;

/**
 * Truth: {@link Bounces}, for ten apexes. Errors depend on where in a step the impact falls, so 25
 * phases of the first impact are tried.
 */
final class BallDrop implements Scenes {

    private static final double RADIUS = 0.25;
    private static final double HEIGHT = 2;
    private static final int PHASES = 25;
    private static final int APEXES = 10;
    private static final double[] ELASTICITIES = {0, 0.3, 0.5, 0.8, 0.95, 1};

    /** Evaluations per impact that would be a defect: bisection to 1e-9 m takes about 30. */
    private static final double MANY_EVALUATIONS = 64;

    @Override
    public void run(Trial trial) {
        for (double e : ELASTICITIES) {
            for (int phase = 0; phase < PHASES; phase++) {
                trial.variant("e " + e + ", phase " + phase);
                double fall = Math.sqrt(2 * HEIGHT / Trial.GRAVITY) + phase * Trial.DT / PHASES;
                drop(trial, new Bounces(Bounces.heightOfFall(fall), e), e);
            }
        }
        Work work = trial.work().all();
        double perImpact = work.evaluations() / Math.max(1.0, work.impacts());
        trial.measure("evaluations per impact", perImpact, "", MANY_EVALUATIONS);
    }

    private static void drop(Trial trial, Bounces truth, double e) {
        WatchedPool pool = trial.ground(0.5, e);
        double start = RADIUS + Bounces.heightOfFall(truth.firstImpact());
        RigidBody ball = pool.add(Solid.disc(RADIUS, 0.5, e).at(0, start));
        double leeway = trial.preset() == Preset.EXACT ? 1e-5 : 1e-2;
        double end = Math.min(truth.impactTime(APEXES + 1), truth.restTime());
        while (pool.time() < end - leeway) {
            pool.step();
            double t = pool.time();
            if (t < end - leeway) {
                double error =
                        truth.apexError(
                                t, leeway, Bounces.apexOf(ball.y() - RADIUS, ball.velocityY()));
                trial.measure("apex", error, "of H", 1e-6, 5e-3);
            }
        }
        if (e < 1) {
            restsAfterwards(trial, pool, ball, truth);
        }
    }

    /** Below e = 1 the bounces end, and then the ball lies on the floor. */
    private static void restsAfterwards(
            Trial trial, WatchedPool pool, RigidBody ball, Bounces truth) {
        pool.run(truth.restTime() + 2 * Trial.DT - pool.time());
        pool.run(0.5);
        double off = Math.abs(Bounces.apexOf(ball.y() - RADIUS, ball.velocityY()));
        trial.measure("height at rest", off, "m", 2 * Trial.TOLERATED_OVERLAP * 2 * RADIUS);
    }
}
