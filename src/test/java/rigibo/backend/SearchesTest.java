package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.backend.setup.Accuracy;
import rigibo.lab.bench.scene.Commotions;
import rigibo.lab.bench.scene.Crowd;
import rigibo.lab.bench.scene.Scene;
import rigibo.lab.engine.RigiBoEngine;

/** How often a step looks for flyers around bodies of piles. */
class SearchesTest {

    private static Pool pool(Scene scene) {
        Pool pool = new Pool(scene.effects(), Accuracy.GAME);
        scene.build(RigiBoEngine.world(pool));
        return pool;
    }

    /** Nobody is led off and nobody falls in, though the pyramid keeps some overlap. */
    @Test
    void nothingIsSearchedAroundWhatSettled() {
        Pool pool = pool(Commotions.settling(12, 0.02));
        int whileItFell = 0;
        for (int i = 0; i < 120; i++) {
            whileItFell += pool.step(Scenes.DT).searches();
        }
        assertThat(whileItFell).isPositive();
        for (int i = 0; i < 60; i++) {
            assertThat(pool.step(Scenes.DT).searches()).as("step %d", i).isZero();
        }
    }

    /**
     * A body may be looked around twice, at the start and at the end of its way, as it is struck,
     * as it is about to bounce and as it is led off.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void aRainIsSearchedAFewTimesABody(long seed) {
        int bodies = 100;
        Pool pool = pool(new Scene(Crowd.EFFECTS, Crowd.BOXES.rain(bodies, seed)));
        int most = 0;
        for (int i = 0; i < 200; i++) {
            most = Math.max(most, pool.step(Scenes.DT).searches());
        }
        assertThat(most).isBetween(1, 6 * bodies);
    }
}
