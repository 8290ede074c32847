package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.effect.Effects;
import rigibo.backend.geometry.Polygon;
import rigibo.backend.law.Preset;
import rigibo.backend.setup.BodyDefinition;
import rigibo.backend.setup.Material;
import rigibo.lab.bench.probe.DeepestOverlap;
import rigibo.lab.bench.scene.Crowd;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.World;

import java.util.Random;

/** Hundreds of bodies that strike each other while they fall, and turn at once. */
@Execution(ExecutionMode.CONCURRENT)
class TumblingCrowdTest {

    private static final int BODIES = 400;

    /** Until the last ones have landed. */
    private static final int STEPS = 170;

    /** Deepest overlap of such a rain, in widths of the smaller body. */
    private static final double MOST = 0.05;

    /**
     * Contacts of what is struck within a substep are followed as it turns: taken for straight
     * until its end, they let the same bodies into each other by up to 0.12 widths.
     */
    @ParameterizedTest
    @CsvSource({"MIXED, 1", "MIXED, 6", "BOXES, 3"})
    void whatIsStruckDoesNotTurnIntoOthers(Crowd crowd, long seed) throws Exception {
        Scene scene = new Scene(Crowd.EFFECTS, crowd.rain(BODIES, seed));
        var engine = Engines.named(RigiBoEngine.NAME);
        try (World world = engine.world(scene.effects(), Engines.setting(engine, "GAME"))) {
            scene.build(world);
            double deepest = 0;
            for (int i = 0; i < STEPS; i++) {
                world.step(Scene.STEP);
                deepest = Math.max(deepest, DeepestOverlap.inWidths(scene, world));
            }
            assertThat(deepest).isBetween(1e-4, MOST);
        }
    }

    /** Heaps of boxes that lie higher than wide sleep within ten seconds of the last landing. */
    @ParameterizedTest
    @EnumSource(names = {"DRAFT", "GAME", "FINE"})
    void highHeapsOfBoxesFallAsleep(Preset preset) {
        for (long seed = 0; seed < 5; seed++) {
            Pool pool = new Pool(Effects.usual(), preset.accuracy);
            Random random = new Random(31 * seed + 200);
            Material rough = Material.DEFAULT.friction(0.6).elasticity(0.1);
            pool.add(BodyDefinition.fixed(Polygon.box(12, 2)).at(0, -1).material(rough));
            for (int side = -1; side <= 1; side += 2) {
                pool.add(BodyDefinition.fixed(Polygon.box(2, 60)).at(5.25 * side, 28));
            }
            for (int i = 0; i < 200; i++) {
                double width = 0.5 + 0.4 * random.nextDouble();
                double height = 0.3 + 0.4 * random.nextDouble();
                pool.add(
                        BodyDefinition.dynamic(Polygon.box(width, height))
                                .at(-3.75 + 1.07 * (i % 8), 0.6 + i / 8)
                                .angle(2 * Math.PI * random.nextDouble())
                                .material(rough));
            }
            for (int i = 0; i < 1000; i++) {
                pool.step(Scenes.DT);
            }
            assertThat(pool.report().awake()).as("bodies awake in heap %d", seed).isZero();
        }
    }
}
