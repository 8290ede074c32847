package rigibo.lab;

import rigibo.backend.Pool;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Rotation;
import rigibo.lab.child.ThreadUse;

import java.util.Arrays;

/**
 * The time that the flood saves without friction. As in its demo, rotation is switched off too,
 * since discs without friction do not need it. Two pools continue from one settled state and are
 * stepped in turn, so that disturbances affect both. Times are processor times of the thread.
 *
 * @param rows of a step at the end, with friction
 * @param rowsWithout likewise without friction
 * @param ratio time of a step without friction over the one beside it with friction, median
 * @param lower quartile of that ratio
 * @param upper quartile
 */
public record FloodFriction(int rows, int rowsWithout, double ratio, double lower, double upper) {

    private static final Flood DEMO = new Flood(19, 0.14);
    private static final int BODIES = 600;
    private static final double COEFFICIENT = 0.4;
    private static final int SETTLING_STEPS = 900;
    private static final int WARM_STEPS = 1800;
    private static final int TIMED_STEPS = 600;

    /** Settles the flood and switches its friction off. */
    public static FloodFriction measure() {
        Effects rubbing = Flood.FRICTIONLESS.with(new Rotation()).with(new Friction());
        Pool with = DEMO.pour(BODIES, rubbing, COEFFICIENT);
        for (int i = 0; i < SETTLING_STEPS; i++) {
            with.step(Flood.STEP);
        }
        Pool without = Pool.restore(with.snapshot());
        without.effects(Flood.FRICTIONLESS);
        double[] ratios = new double[TIMED_STEPS];
        for (int i = -WARM_STEPS; i < TIMED_STEPS; i++) {
            long begun = ThreadUse.nanos();
            with.step(Flood.STEP);
            long between = ThreadUse.nanos();
            without.step(Flood.STEP);
            long ended = ThreadUse.nanos();
            if (i >= 0) {
                ratios[i] = (double) (ended - between) / (between - begun);
            }
        }
        Arrays.sort(ratios);
        return new FloodFriction(
                with.report().rows(),
                without.report().rows(),
                ratios[TIMED_STEPS / 2],
                ratios[TIMED_STEPS / 4],
                ratios[TIMED_STEPS * 3 / 4]);
    }
}
