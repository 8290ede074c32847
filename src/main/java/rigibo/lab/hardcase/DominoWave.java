package rigibo.lab.hardcase;

import rigibo.backend.RigidBody;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;

/**
 * A row of dominoes of 0.25 × 1 at a spacing of 1, the first struck by 0.2 N·s at its top. Truth:
 * what a domino hands on to the next depends only on what it was handed, so the wave forgets how it
 * began and goes on at a speed of its own (W. J. Stronge, The domino effect, 1987): beyond the
 * first few, every domino falls the same time after the one before it.
 */
final class DominoWave implements HardCase {

    private static final int COUNT = 30;
    private static final int FIRST_STEADY = 10;

    /** The last few have none behind them to lean on. */
    private static final int LAST_STEADY = 25;

    private static final double WIDTH = 0.25;
    private static final double IMPULSE = 0.2;
    private static final double HORIZON = 30;

    @Override
    public String row() {
        return "60/wave";
    }

    @Override
    public String title() {
        return "the wave of falling dominoes is steady";
    }

    @Override
    public void run(Trial trial) {
        WatchedPool pool = trial.pool(Surroundings.earth());
        pool.add(Surroundings.floor(0.5, 0));
        List<RigidBody> dominoes = new ArrayList<>();
        for (int i = 0; i < COUNT; i++) {
            dominoes.add(pool.add(BodyDefinition.dynamic(Polygon.box(WIDTH, 1)).at(i, 0.5)));
        }
        dominoes.get(0).applyImpulse(IMPULSE, 0, 0, 1);
        pool.changed();
        double[] times = times(pool, dominoes);
        double mean = (times[LAST_STEADY] - times[FIRST_STEADY]) / (LAST_STEADY - FIRST_STEADY);
        for (int i = FIRST_STEADY; i < LAST_STEADY; i++) {
            double off = Math.abs((times[i + 1] - times[i]) / mean - 1);
            trial.measure("interval", off, "of the mean", 0.02, 0.05);
        }
        trial.report("speed of the wave", 1 / mean, "m/s");
    }

    /** When each domino's centre passes over its edge, interpolated between two steps. */
    private static double[] times(WatchedPool pool, List<RigidBody> dominoes) {
        double edge = -Math.atan(WIDTH);
        double[] times = new double[COUNT];
        double[] before = new double[COUNT];
        while (pool.time() < HORIZON) {
            pool.step();
            for (int i = 0; i < COUNT; i++) {
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
