package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;

/** Changing the accuracy between two steps does not disturb bodies at rest. */
class AccuracyChangeTest {

    private static final double STEP = 1.0 / 60;
    private static final int STEPS_EACH = 30;
    private static final List<Accuracy> PRESETS =
            List.of(Accuracy.DRAFT, Accuracy.GAME, Accuracy.FINE, Accuracy.EXACT);

    /**
     * A tenth of the tolerated overlap of 1 mm: what presets may differ by in how deep contacts lie
     * at rest.
     */
    private static final double UNSEEN = 1e-4;

    /** Every change from one preset to another, one after the other, with sleep left out. */
    @Test
    void whatRestsGoesOnResting() {
        Pool pool = new Pool(Effects.usual().without(Sleep.class), Accuracy.GAME);
        pool.add(BodyDefinition.fixed(Polygon.box(40, 1)).at(0, -0.5));
        List<RigidBody> resting = new ArrayList<>();
        for (int i = 0; i < 10; i++) {
            resting.add(pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(-5, i + 0.5)));
        }
        for (int row = 0; row < 4; row++) {
            for (int i = 0; i < 4 - row; i++) {
                double x = 3 + i + row / 2.0;
                resting.add(pool.add(BodyDefinition.dynamic(Polygon.box(1, 1)).at(x, row + 0.5)));
            }
        }
        resting.add(pool.add(BodyDefinition.dynamic(new Circle(0.5)).at(12, 0.5)));
        run(pool, 120);
        for (Accuracy from : PRESETS) {
            for (Accuracy to : PRESETS) {
                pool.accuracy(from);
                run(pool, STEPS_EACH);
                double[] before = poses(resting);
                pool.accuracy(to);
                run(pool, STEPS_EACH);
                double[] after = poses(resting);
                for (int i = 0; i < before.length; i++) {
                    assertThat(Math.abs(after[i] - before[i]))
                            .as("body %s from %s to %s", i / 3, from, to)
                            .isLessThan(UNSEEN);
                }
            }
        }
    }

    private static void run(Pool pool, int steps) {
        for (int i = 0; i < steps; i++) {
            pool.step(STEP);
        }
    }

    private static double[] poses(List<RigidBody> bodies) {
        return bodies.stream()
                .flatMapToDouble(body -> DoubleStream.of(body.x(), body.y(), body.angle()))
                .toArray();
    }
}
