package rigibo.frontend.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

import java.util.OptionalInt;

class ProgressTest {

    private static final long HASH = 7;
    private static final long CHANGED = 8;

    @Test
    void beginsWithNothing() {
        assertThat(Progress.none().of("tilt", HASH))
                .isEqualTo(new LevelProgress(HASH, false, OptionalInt.empty(), 0));
    }

    @Test
    void keepsTheFewestClicksOfAllTries() {
        Progress progress = Progress.none().solved("tilt", HASH, 3);
        assertThat(progress.solved("tilt", HASH, 2).of("tilt", HASH).fewestClicks()).hasValue(2);
        assertThat(progress.solved("tilt", HASH, 5).of("tilt", HASH).fewestClicks()).hasValue(3);
    }

    @Test
    void countsFailuresSinceTheLastSolution() {
        Progress twice = Progress.none().failed("tilt", HASH).failed("tilt", HASH);
        assertThat(twice.of("tilt", HASH).failures()).isEqualTo(2);
        assertThat(twice.of("seesaw", HASH).failures()).isZero();
        Progress solved = twice.solved("tilt", HASH, 2);
        assertThat(solved.of("tilt", HASH).failures()).isZero();
        assertThat(solved.failed("tilt", HASH).of("tilt", HASH))
                .isEqualTo(new LevelProgress(HASH, true, OptionalInt.of(2), 1));
    }

    @Test
    void aChangedLevelStaysSolvedButItsClicksAreThoseOfAnotherLevel() {
        Progress progress = Progress.none().solved("tilt", HASH, 2).failed("tilt", HASH);
        assertThat(progress.of("tilt", CHANGED))
                .isEqualTo(new LevelProgress(CHANGED, true, OptionalInt.empty(), 0));
        assertThat(progress.solved("tilt", CHANGED, 4).of("tilt", CHANGED).fewestClicks())
                .hasValue(4);
    }

    @Test
    void refusesWhatCannotBe() {
        assertThatThrownBy(() -> new LevelProgress(HASH, true, OptionalInt.of(-1), 0))
                .hasMessageContaining("fewestClicks");
        assertThatThrownBy(() -> new LevelProgress(HASH, true, OptionalInt.of(1), -1))
                .hasMessageContaining("failures");
        assertThatThrownBy(() -> new LevelProgress(HASH, false, OptionalInt.of(1), 0))
                .hasMessageContaining("solved");
    }
}
