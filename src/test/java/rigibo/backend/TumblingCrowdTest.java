package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

import rigibo.lab.bench.probe.DeepestOverlap;
import rigibo.lab.bench.scene.Crowd;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.Engines;
import rigibo.lab.engine.RigiBoEngine;
import rigibo.lab.engine.World;

/** Hundreds of bodies that strike each other while they fall, and turn at once. */
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
}
