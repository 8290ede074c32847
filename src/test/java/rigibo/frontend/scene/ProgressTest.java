package rigibo.frontend.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

import java.time.LocalDate;
import java.util.Map;
import java.util.OptionalInt;
import java.util.TreeMap;

class ProgressTest {

    private static final long HASH = 7;
    private static final long CHANGED = 8;

    @Test
    void beginsWithNothing() {
        assertThat(Progress.none().of("tilt", HASH))
                .isEqualTo(new LevelProgress(HASH, false, OptionalInt.empty(), 0, false));
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
                .isEqualTo(new LevelProgress(HASH, true, OptionalInt.of(2), 1, false));
    }

    @Test
    void aChangedLevelStaysSolvedButItsClicksAreThoseOfAnotherLevel() {
        Progress progress = Progress.none().solved("tilt", HASH, 2).failed("tilt", HASH);
        assertThat(progress.of("tilt", CHANGED))
                .isEqualTo(new LevelProgress(CHANGED, true, OptionalInt.empty(), 0, false));
        assertThat(progress.solved("tilt", CHANGED, 4).of("tilt", CHANGED).fewestClicks())
                .hasValue(4);
    }

    @Test
    void aStarStaysFoundWhateverComesLater() {
        Progress found = Progress.none().solved("tilt", HASH, 3).starred("tilt", HASH);
        assertThat(found.solved("tilt", HASH, 2).failed("tilt", HASH).of("tilt", HASH).hasStar())
                .isTrue();
        assertThat(found.of("tilt", CHANGED).hasStar()).isTrue();
        Progress elsewhere = Progress.none().solved("tilt", HASH, 1);
        assertThat(elsewhere.with(found).of("tilt", HASH))
                .isEqualTo(new LevelProgress(HASH, true, OptionalInt.of(1), 0, true));
    }

    @Test
    void bestResultOfADayHasFewestClicksThenTheShortestTime() {
        LocalDate date = LocalDate.of(2026, 11, 27);
        Progress progress = Progress.none().solvedDay(date, new DayResult(3, 900));
        assertThat(progress.solvedDay(date, new DayResult(2, 1200)).days())
                .containsEntry(date, new DayResult(2, 1200));
        assertThat(progress.solvedDay(date, new DayResult(3, 800)).days())
                .containsEntry(date, new DayResult(3, 800));
        assertThat(progress.solvedDay(date, new DayResult(4, 100)).days())
                .containsEntry(date, new DayResult(3, 900));
    }

    @Test
    void whatTwoGamesHaveDoneCountsTogether() {
        LocalDate date = LocalDate.of(2026, 11, 27);
        Progress here = Progress.none().solvedDay(date, new DayResult(3, 900)).endless(5);
        Progress there =
                Progress.none()
                        .solvedDay(date, new DayResult(2, 900))
                        .solvedDay(date.plusDays(1), new DayResult(4, 900))
                        .endless(3);
        Progress both = here.with(there);
        assertThat(both).isEqualTo(there.with(here));
        assertThat(both.endless()).isEqualTo(5);
        assertThat(both.days())
                .containsOnly(
                        Map.entry(date, new DayResult(2, 900)),
                        Map.entry(date.plusDays(1), new DayResult(4, 900)));
    }

    @Test
    void endlessLevelsAreNotGoneBackTo() {
        assertThat(Progress.none().endless()).isEqualTo(1);
        assertThat(Progress.none().endless(7).endless(3).endless()).isEqualTo(7);
    }

    @Test
    void totalsGrowAndStopAtTheLargestNumber() {
        Totals some = new Totals(1, 2, 3).plus(new Totals(10, 20, 30));
        assertThat(some).isEqualTo(new Totals(11, 22, 33));
        assertThat(some.since(new Totals(1, 2, 3))).isEqualTo(new Totals(10, 20, 30));
        Totals most = new Totals(0, 0, Integer.MAX_VALUE);
        assertThat(most.plus(some).steps()).isEqualTo(Integer.MAX_VALUE);
        assertThat(Progress.none().played(some).played(some).totals())
                .isEqualTo(new Totals(22, 44, 66));
    }

    @Test
    void refusesWhatCannotBe() {
        assertThatThrownBy(() -> new Totals(0, -1, 0)).hasMessageContaining("-1 clicks");
        assertThatThrownBy(() -> new DayResult(0, 1)).hasMessageContaining("clicks");
        assertThatThrownBy(() -> new DayResult(1, 0)).hasMessageContaining("steps");
        assertThatThrownBy(() -> new Progress(new TreeMap<>(), new TreeMap<>(), 0, Totals.NONE))
                .hasMessageContaining("endless");
        assertThatThrownBy(() -> new LevelProgress(HASH, true, OptionalInt.of(-1), 0, false))
                .hasMessageContaining("fewestClicks");
        assertThatThrownBy(() -> new LevelProgress(HASH, true, OptionalInt.of(1), -1, false))
                .hasMessageContaining("failures");
        assertThatThrownBy(() -> new LevelProgress(HASH, false, OptionalInt.of(1), 0, false))
                .hasMessageContaining("solved");
        assertThatThrownBy(() -> new LevelProgress(HASH, false, OptionalInt.empty(), 0, true))
                .hasMessageContaining("hasStar");
    }
}
