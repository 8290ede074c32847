package rigibo.backend.law;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

import rigibo.backend.setup.Accuracy;

import java.util.Optional;

/** The harness itself: a law that breaks is told with its seed and its fewest bodies. */
@Execution(ExecutionMode.CONCURRENT)
class LawsTest {

    /** Broken wherever a body starts to the right of a metre and another to the left. */
    private static final Law LOPSIDED =
            (scene, asked) -> {
                asked.more(1);
                boolean right = scene.bodies().stream().anyMatch(body -> body.x() > 1);
                boolean left = scene.bodies().stream().anyMatch(body -> body.x() < -1);
                return right && left ? Optional.of("lopsided") : Optional.empty();
            };

    private static final Seeds SEEDS = Seeds.upTo(100);

    private static boolean isLopsided(RandomScene scene) {
        return LOPSIDED.broken(scene, new Asked()).isPresent();
    }

    private static RandomScene scene(long seed) {
        return Surroundings.meeting(seed, Accuracy.GAME);
    }

    @Test
    void sceneIsCutDownToTheBodiesThatBreakTheLaw() {
        for (long seed = 1; seed <= 100; seed++) {
            if (isLopsided(scene(seed))) {
                RandomScene small = Laws.cutDown(scene(seed), LOPSIDED);
                assertThat(small.bodies()).as("seed %d", seed).hasSize(2);
                assertThat(isLopsided(small)).as("seed %d", seed).isTrue();
            }
        }
    }

    @Test
    void failureNamesItsSeedAndTheBodiesAsCode() {
        assertThatThrownBy(
                        () -> Laws.hold(SEEDS, LawsTest::scene, LOPSIDED, new Quota(1, "scenes")))
                .isInstanceOf(AssertionError.class)
                .hasMessageContaining("seed ")
                .hasMessageContaining("with 2 of its ")
                .hasMessageContaining("pool.add(BodyDefinition.dynamic(");
    }

    @Test
    void lawThatWasHardlyAskedFails() {
        Law kept =
                (scene, asked) -> {
                    asked.more(scene.seed() % 2);
                    return Optional.empty();
                };
        Laws.hold(SEEDS, LawsTest::scene, kept, new Quota(50, "odd seeds"));
        assertThatThrownBy(
                        () -> Laws.hold(SEEDS, LawsTest::scene, kept, new Quota(54, "odd seeds")))
                .isInstanceOf(AssertionError.class)
                .hasMessageMatching("asked (17 of at least 18|50 of at least 54) odd seeds");
        assertThatThrownBy(() -> new Quota(0, "odd seeds"))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void seedsLeftOutAreAmongThoseThatRun() {
        assertThat(Seeds.upTo(4).without(Seeds.of(2L)).all()).containsExactly(1L, 3L, 4L);
        assertThatThrownBy(() -> Seeds.upTo(4).without(Seeds.of(5L)))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void askedKeepsWhatCameNearestToItsLimit() {
        Asked asked = new Asked();
        asked.atMost(4, 3, "x");
        asked.atMost(4, 1, "x");
        asked.atMost(0, 0, "x");
        assertThat(asked.nearest()).isEqualTo(0.75);
    }

    @Test
    void figureThatIsNotANumberBreaksEveryLaw() {
        assertThat(new Asked().atMost(1, Double.NaN, "x")).isPresent();
        assertThat(new Asked().atMost(1, 1, "x")).isEmpty();
    }

    @Test
    void seedsGiveTheSameSceneAgain() {
        assertThat(scene(7).words()).isEqualTo(scene(7).words());
        assertThat(scene(7).words()).isNotEqualTo(scene(8).words());
    }
}
