package rigibo.frontend.menu;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

import rigibo.frontend.scene.DayResult;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Legibility;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.RecordingCanvas;
import rigibo.frontend.scene.RecordingDirector;
import rigibo.frontend.scene.Totals;

import java.time.LocalDate;
import java.util.TreeSet;
import java.util.stream.Stream;

/** The page of statistics, and how it counts days in a row. */
class StatisticsTest {

    private static final LocalDate TODAY = LocalDate.of(2026, 11, 27);

    /** Days as numbers of November; today is the 27th. */
    @ParameterizedTest
    @CsvSource({
        "'', 0, 0",
        "27, 1, 1",
        "26, 1, 1",
        "25, 0, 1",
        "25 26 27, 3, 3",
        "20 21 22 23 26 27, 2, 4",
        "25 26 28, 0, 2",
    })
    void daysInARowMayLackTodayOnly(String days, int present, int longest) {
        TreeSet<LocalDate> solved = new TreeSet<>();
        Stream.of(days.split(" "))
                .filter(day -> !day.isEmpty())
                .forEach(day -> solved.add(TODAY.withDayOfMonth(Integer.parseInt(day))));
        assertThat(Streak.of(solved, TODAY)).isEqualTo(new Streak(present, longest));
    }

    private static Progress some() {
        return Progress.none()
                .solved("level0", Entries.HASH, 2)
                .starred("level0", Entries.HASH)
                .solved("level1", Entries.HASH, 3)
                .solved("level2", Entries.HASH, 9)
                .solved("level3", Entries.HASH, 2)
                .solvedDay(TODAY, new DayResult(2, 700))
                .solvedDay(TODAY.minusDays(1), new DayResult(3, 700))
                .solvedDay(TODAY.minusDays(9), new DayResult(3, 700))
                .endless(12)
                .played(new Totals(1234, 4567, 60 * 7265));
    }

    private static StatisticsScene scene(RecordingDirector director) {
        return new StatisticsScene(director, Entries.all(21), TODAY);
    }

    @Test
    void everythingThatTheFilesKnowIsTold() {
        RecordingDirector director = new RecordingDirector();
        director.progress(some());
        assertThat(RecordingCanvas.of(scene(director)).texts())
                .contains("4 of 21 solved", "1 / 21", "1,234", "4,567", "2 h 1 min")
                .containsSequence("2", "gold")
                .containsSequence("1", "silver")
                .containsSequence("1", "bronze")
                .containsSequence("3", "days solved", "2", "days in a row", "2", "most in a row")
                .contains("You are at No. 12")
                .doesNotContain("counted since this version");
        scene(director).keyPressed(Key.ENTER);
        assertThat(director.asked).containsExactly("menu");
    }

    /** Files of a version that counted no tries tell more solved levels than tries. */
    @Test
    void whatWasNotCountedBeforeIsToldToBeSo() {
        RecordingDirector director = new RecordingDirector();
        director.progress(some().withTotals(Totals.NONE));
        assertThat(RecordingCanvas.of(scene(director)).texts())
                .contains("counted since this version", "0 min 0 s");
    }

    @ParameterizedTest
    @ValueSource(strings = {"en", "de"})
    void allOfItCanBeRead(String language) {
        RecordingDirector director = new RecordingDirector(language);
        assertThat(Legibility.faults(scene(director))).isEmpty();
        int most = Integer.MAX_VALUE;
        director.progress(some().endless(most).withTotals(new Totals(most, most, most)));
        assertThat(Legibility.faults(scene(director))).isEmpty();
        director.progress(some().withTotals(Totals.NONE));
        assertThat(Legibility.faults(scene(director))).isEmpty();
    }
}
