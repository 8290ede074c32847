package rigibo.backend;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

import rigibo.backend.geometry.Circle;
import rigibo.backend.setup.BodyDefinition;

/** The same calls give the same bits. */
@Execution(ExecutionMode.CONCURRENT)
class DeterminismTest {

    private static final int STEPS = 300;

    @ParameterizedTest
    @EnumSource(Scenes.class)
    void twoRunsHaveEqualHashes(Scenes scene) {
        assertThat(hashAfter(scene))
                .as("%s, seed %d", scene, Scenes.SEED)
                .isEqualTo(hashAfter(scene));
    }

    @ParameterizedTest
    @EnumSource(Scenes.class)
    void interleavedPoolsDoNotKnowEachOther(Scenes scene) {
        Pool one = scene.build();
        Pool two = scene.build();
        Pool stranger = Scenes.MIXTURE.build();
        for (int i = 0; i < STEPS; i++) {
            one.step(Scenes.DT);
            stranger.step(Scenes.DT);
            two.step(Scenes.DT);
            assertThat(two.stateHash()).as("%s, step %d", scene, i).isEqualTo(one.stateHash());
        }
        assertThat(one.stateHash()).as("alone or in company").isEqualTo(hashAfter(scene));
    }

    @Test
    void queriesLeaveNoTrace() {
        Pool pool = Scenes.MIXTURE.build();
        Pool asked = Scenes.MIXTURE.build();
        for (int i = 0; i < STEPS; i++) {
            pool.step(Scenes.DT);
            asked.step(Scenes.DT);
            asked.bodyAt(0, 0.5);
            asked.rayCast(-8, 1, 8, 1);
            asked.contactEvents();
            asked.kineticEnergy();
            asked.stateHash();
        }
        assertThat(asked.stateHash()).isEqualTo(pool.stateHash());
    }

    @Test
    void hashSeesTheLastBitOfEveryNumber() {
        BodyDefinition disc = BodyDefinition.dynamic(new Circle(1)).at(1, 2).velocity(3, 4).spin(5);
        long hash = hashOf(disc);
        assertThat(hashOf(disc)).isEqualTo(hash);
        assertThat(hashOf(disc.at(Math.nextUp(1.0), 2))).isNotEqualTo(hash);
        assertThat(hashOf(disc.at(1, Math.nextUp(2.0)))).isNotEqualTo(hash);
        assertThat(hashOf(disc.angle(Double.MIN_VALUE))).isNotEqualTo(hash);
        assertThat(hashOf(disc.velocity(Math.nextUp(3.0), 4))).isNotEqualTo(hash);
        assertThat(hashOf(disc.velocity(3, Math.nextUp(4.0)))).isNotEqualTo(hash);
        assertThat(hashOf(disc.spin(Math.nextUp(5.0)))).isNotEqualTo(hash);
        assertThat(hashOf(disc.group(1))).isNotEqualTo(hash);
        assertThat(hashOf(disc.gravityScale(Math.nextUp(1.0)))).isNotEqualTo(hash);
        assertThat(hashOf(disc.mass(1))).isNotEqualTo(hash);
    }

    private static long hashOf(BodyDefinition definition) {
        Pool pool = new Pool();
        pool.add(definition);
        return pool.stateHash();
    }

    private static long hashAfter(Scenes scene) {
        Pool pool = scene.build();
        Scenes.run(pool, STEPS);
        return pool.stateHash();
    }
}
