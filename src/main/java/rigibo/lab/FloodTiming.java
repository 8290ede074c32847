package rigibo.lab;

import rigibo.backend.Pool;
import rigibo.backend.StepReport;
import rigibo.backend.effect.Contacts;
import rigibo.backend.effect.ContinuousImpacts;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Gravity;
import rigibo.backend.effect.Restitution;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;

import java.util.Arrays;
import java.util.SplittableRandom;

/**
 * How long a step of the flood takes: discs of r = 0.25 m and elasticity 0.5 that fall into a
 * trough of 40 m and settle there, without friction and without sleep, at {@code GAME}.
 *
 * @param bodies discs
 * @param medianMillis median time of a step, ms
 * @param p99Millis 99th percentile, ms
 * @param deepestOverlap at the end, m: a fast run that sinks is no run
 */
public record FloodTiming(
        int bodies, double medianMillis, double p99Millis, double deepestOverlap) {

    private static final double STEP = 1.0 / 60;
    private static final double TROUGH = 40;
    private static final double RADIUS = 0.25;
    private static final int COLUMNS = 60;
    private static final int WARM_STEPS = 300;
    private static final int TIMED_STEPS = 900;

    /** Runs the flood with this many discs. */
    public static FloodTiming measure(int bodies) {
        Pool pool = trough();
        pour(pool, bodies);
        double[] millis = new double[TIMED_STEPS];
        for (int i = -WARM_STEPS; i < TIMED_STEPS; i++) {
            long before = System.nanoTime();
            pool.step(STEP);
            if (i >= 0) {
                millis[i] = (System.nanoTime() - before) / 1e6;
            }
        }
        Arrays.sort(millis);
        StepReport report = pool.report();
        return new FloodTiming(
                bodies,
                millis[TIMED_STEPS / 2],
                millis[TIMED_STEPS * 99 / 100],
                report.deepestOverlap());
    }

    private static Pool trough() {
        Effects effects =
                Effects.of(
                        new Gravity(0, -9.81),
                        new Contacts(),
                        new Restitution(),
                        new ContinuousImpacts());
        Pool pool = new Pool(effects, Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(TROUGH + 2, 1)).at(0, -0.5));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 400)).at(-TROUGH / 2 - 0.5, 199));
        pool.add(BodyDefinition.fixed(Polygon.box(1, 400)).at(TROUGH / 2 + 0.5, 199));
        return pool;
    }

    private static void pour(Pool pool, int bodies) {
        SplittableRandom random = new SplittableRandom(1);
        Material drop = new Material(1, 0, 0.5);
        for (int i = 0; i < bodies; i++) {
            double x = -TROUGH / 2 + 0.5 + (i % COLUMNS) * 0.65 + 0.1 * random.nextDouble();
            double y = 1 + (i / COLUMNS) * 0.6;
            pool.add(BodyDefinition.dynamic(new Circle(RADIUS)).at(x, y).material(drop));
        }
    }
}
