package rigibo.backend.law;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

import rigibo.backend.setup.Accuracy;

import java.util.Optional;

/** The harness itself: a law that breaks is told with its seed and its fewest bodies. */
class LawsTest {

    /** Broken wherever a body starts to the right of a metre and another to the left. */
    private static final Law LOPSIDED =
            scene -> {
                boolean right = scene.bodies().stream().anyMatch(body -> body.x() > 1);
                boolean left = scene.bodies().stream().anyMatch(body -> body.x() < -1);
                return right && left ? Optional.of("lopsided") : Optional.empty();
            };

    private static RandomScene scene(long seed) {
        return Surroundings.meeting(seed, Accuracy.GAME);
    }

    @Test
    void sceneIsCutDownToTheBodiesThatBreakTheLaw() {
        for (long seed = 1; seed <= 100; seed++) {
            if (LOPSIDED.broken(scene(seed)).isPresent()) {
                RandomScene small = Laws.cutDown(scene(seed), LOPSIDED);
                assertThat(small.bodies()).as("seed %d", seed).hasSize(2);
                assertThat(LOPSIDED.broken(small)).as("seed %d", seed).isPresent();
            }
        }
    }

    @Test
    void failureNamesItsSeedAndTheBodiesAsCode() {
        assertThatThrownBy(() -> Laws.hold(1, 100, LawsTest::scene, LOPSIDED))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("seed ")
                .hasMessageContaining("with 2 of its ")
                .hasMessageContaining("pool.add(BodyDefinition.dynamic(");
    }

    @Test
    void figureThatIsNotANumberBreaksEveryLaw() {
        assertThat(Law.atMost(1, Double.NaN, "x")).isPresent();
        assertThat(Law.atMost(1, 1, "x")).isEmpty();
    }

    @Test
    void seedsGiveTheSameSceneAgain() {
        assertThat(scene(7).words()).isEqualTo(scene(7).words());
        assertThat(scene(7).words()).isNotEqualTo(scene(8).words());
    }
}
