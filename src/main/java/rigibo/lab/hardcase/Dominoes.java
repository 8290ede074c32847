package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.lab.truth.Solid;

import java.util.List;
import java.util.stream.IntStream;

/**
 * Fifteen dominoes of 0.25 × 1 at a spacing of 1, the first struck at its top by 0.2 N·s. Truth:
 * all fall and end at rest. A single one that turns about its lower edge falls if its energy I·ω²/2
 * with I = m(w² + h²)/3 lifts its centre over the edge, by (√(w² + h²) − h)/2: from ω0 = 0.9233
 * rad/s.
 */
final class Dominoes {

    private static final int COUNT = 15;
    private static final double WIDTH = 0.25;
    private static final double IMPULSE = 0.2;
    private static final double HORIZON = 20;

    /** Number of dominoes in the row of a wave. */
    private static final int WAVE = 30;

    private static final double WAVE_HORIZON = 30;
    private static final int FIRST_STEADY = 10;

    /** Last domino of the steady wave: the few behind it have none to lean on. */
    private static final int LAST_STEADY = 25;

    private Dominoes() {}

    static void fall(Trial trial) {
        trial.variant("row");
        fallInARow(trial);
        double diagonal = Math.hypot(WIDTH, 1);
        double lift = (diagonal - 1) / 2;
        double threshold = Math.sqrt(2 * Trial.GRAVITY * lift / (diagonal * diagonal / 3));
        for (double share : new double[] {0.99, 1.01}) {
            trial.variant(share + " of the threshold");
            boolean falls = falls(trial, share * threshold);
            trial.require("falls above the threshold only", falls == share > 1);
        }
    }

    private static void fallInARow(Trial trial) {
        WatchedPool pool = trial.ground(0.5, 0);
        List<RigidBody> dominoes = struck(pool, COUNT);
        pool.run(HORIZON);
        for (RigidBody domino : dominoes) {
            trial.require("every domino falls", domino.angle() < -Math.PI / 4);
        }
        trial.measure("fastest in the end", pool.fastest(), "m/s", 1e-3);
    }

    /** Whether a domino falls that turns about its lower right edge, at rest: v = ω × r. */
    private static boolean falls(Trial trial, double spin) {
        WatchedPool pool = trial.ground(0.9, 0);
        RigidBody domino =
                pool.add(
                        Solid.box(WIDTH, 1, 0.9, 0)
                                .at(0, 0.5)
                                .velocity(spin / 2, spin * WIDTH / 2)
                                .spin(-spin));
        pool.run(4);
        return domino.angle() < -Math.PI / 4;
    }

    /** A row of dominoes, the first of which is struck. */
    private static List<RigidBody> struck(WatchedPool pool, int count) {
        List<RigidBody> dominoes =
                IntStream.range(0, count)
                        .mapToObj(i -> pool.add(Solid.box(WIDTH, 1).at(i, 0.5)))
                        .toList();
        dominoes.get(0).applyImpulse(IMPULSE, 0, 0, 1);
        pool.changed();
        return dominoes;
    }

    /**
     * A longer row. Truth: what a domino passes on depends only on what it received, so the wave
     * forgets its beginning and travels at a speed of its own (W. J. Stronge, The domino effect,
     * 1987): beyond the first few, all dominoes fall at equal intervals.
     */
    static void wave(Trial trial) {
        WatchedPool pool = trial.ground(0.5, 0);
        double[] times = times(pool, struck(pool, WAVE));
        double mean = (times[LAST_STEADY] - times[FIRST_STEADY]) / (LAST_STEADY - FIRST_STEADY);
        for (int i = FIRST_STEADY; i < LAST_STEADY; i++) {
            trial.relativeError(
                    "interval", times[i + 1] - times[i], mean, "of the mean", 0.02, 0.05);
        }
        trial.report("speed of the wave", 1 / mean, "m/s");
    }

    /** Times at which the dominoes' centres pass over their edges, between steps, s. */
    private static double[] times(WatchedPool pool, List<RigidBody> dominoes) {
        double edge = -Math.atan(WIDTH);
        double[] times = new double[WAVE];
        double[] before = new double[WAVE];
        while (pool.time() < WAVE_HORIZON) {
            pool.step();
            for (int i = 0; i < WAVE; i++) {
                double angle = dominoes.get(i).angle();
                if (times[i] == 0 && angle < edge) {
                    double share = (edge - before[i]) / (angle - before[i]);
                    times[i] = pool.time() - (1 - share) * Trial.DT;
                }
                before[i] = angle;
            }
        }
        return times;
    }
}
