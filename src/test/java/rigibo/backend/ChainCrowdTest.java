package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Sleep;
import rigibo.backend.geometry.Chain;
import rigibo.backend.geometry.Circle;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.setup.Accuracy;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.BodyType;
import rigibo.backend.setup.Material;

import java.util.SplittableRandom;

/** Heaps that fall on chains, whose bodies are struck while they move over its edges. */
@Execution(ExecutionMode.CONCURRENT)
class ChainCrowdTest {

    private static final double DT = 1 / 60.0;
    private static final Effects AWAKE = Effects.usual().without(Sleep.class);
    private static final Material STONE = new Material(1, 0.6, 0.1);

    /** Half of the ground's width, m. */
    private static final double HALF = 10;

    /**
     * The limit of overlap for heaps on a floor in one piece, 0.02 widths, also holds on edges of
     * any length: on flat ones, and on waves whose ridges are as sharp as a body is wide.
     */
    @ParameterizedTest
    @ValueSource(ints = {16, 50, 200, 1000})
    void noHeapSinksIntoAChain(int edges) {
        for (double wave : new double[] {0, 0.4}) {
            for (long seed = 1; seed <= 3; seed++) {
                Pool pool = new Pool(AWAKE, Accuracy.GAME);
                pool.add(BodyDefinition.fixed(ground(edges, wave)).material(STONE));
                addRain(pool, seed);
                double deepest = 0;
                for (int i = 0; i < 200; i++) {
                    pool.step(DT);
                    deepest = Math.max(deepest, deepestInGround(pool));
                }
                assertThat(deepest)
                        .as("%d edges, waves of %.1f m, seed %d", edges, wave, seed)
                        .isLessThan(0.02);
            }
        }
    }

    /** From right to left, with waves of 5 m, up to walls on either side. */
    private static Chain ground(int edges, double height) {
        double[] xy = new double[2 * edges + 6];
        xy[0] = HALF;
        xy[1] = 3 * HALF;
        for (int i = 0; i <= edges; i++) {
            double x = HALF - 2 * HALF * i / edges;
            xy[2 * i + 2] = x;
            xy[2 * i + 3] = height * StrictMath.cos(2 * Math.PI * x / 5);
        }
        xy[2 * edges + 4] = -HALF;
        xy[2 * edges + 5] = 3 * HALF;
        return Chain.open(xy);
    }

    private static void addRain(Pool pool, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 60; i++) {
            double w = random.nextDouble(0.5, 0.9);
            double h = random.nextDouble(0.3, 0.7);
            var shape = i % 2 == 0 ? Polygon.box(w, h) : new Circle(h / 2);
            pool.add(
                    BodyDefinition.dynamic(shape)
                            .at(1.2 * (i % 10 - 4.5), 4 + 1.2 * (i / 10))
                            .angle(random.nextDouble(6))
                            .velocity(random.nextDouble(-5, 5), -5)
                            .material(STONE));
        }
    }

    /** In widths of what lies in the ground. */
    private static double deepestInGround(Pool pool) {
        double[] deepest = {0};
        pool.forEachContact(
                contact -> {
                    boolean isA = contact.a.type() == BodyType.DYNAMIC;
                    boolean isB = contact.b.type() == BodyType.DYNAMIC;
                    double width = (isA ? contact.a : contact.b).shape().smallestWidth();
                    for (int i = 0; i < contact.points && isA != isB; i++) {
                        deepest[0] = Math.max(deepest[0], -contact.separation[i] / width);
                    }
                });
        return deepest[0];
    }
}
