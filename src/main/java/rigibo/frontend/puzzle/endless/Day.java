package rigibo.frontend.puzzle.endless;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.Wording;
import rigibo.frontend.puzzle.record.Ledger;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.DayResult;
import rigibo.frontend.scene.Director;
import rigibo.frontend.scene.Words;

import java.time.Clock;
import java.time.DateTimeException;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.LongStream;

/**
 * The level of a day, the same for all players: its seed is the date.
 *
 * @param date by UTC
 */
public record Day(LocalDate date) implements Occasion {

    /** Seeds of a day. A date without a level at any of ten seeds is very unlikely. */
    private static final int SEEDS = 10;

    /** Distance between the seeds of a day: larger than any date as a number. */
    private static final long PITCH = 100_000_000;

    private static final int YEAR = 10_000;
    private static final int MONTH = 100;

    /** Seeds of earlier years are numbers of endless levels. */
    private static final int FIRST_YEAR = 2000;

    /** The day that a clock shows in UTC. */
    public static Day of(Clock clock) {
        return new Day(clock.instant().atZone(ZoneOffset.UTC).toLocalDate());
    }

    /** The day that a seed belongs to; empty for a seed of an endless level. */
    public static Optional<Day> ofSeed(long seed) {
        long number = seed % PITCH;
        if (seed / PITCH >= SEEDS || number < FIRST_YEAR * (long) YEAR) {
            return Optional.empty();
        }
        try {
            int year = (int) (number / YEAR);
            int month = (int) (number % YEAR / MONTH);
            int day = (int) (number % MONTH);
            return Optional.of(new Day(LocalDate.of(year, month, day)));
        } catch (DateTimeException isNoDate) {
            return Optional.empty();
        }
    }

    @Override
    public List<Long> seeds() {
        long first =
                date.getYear() * (long) YEAR + date.getMonthValue() * MONTH + date.getDayOfMonth();
        return LongStream.range(0, SEEDS).map(i -> first + i * PITCH).boxed().toList();
    }

    @Override
    public String title(Words words) {
        return words.of("made.day", written(words, date));
    }

    /** Formats a date in the player's language. */
    private static String written(Words words, LocalDate day) {
        String[] parts = day.toString().split("-");
        return words.of("made.date", parts[0], parts[1], parts[2]);
    }

    @Override
    public String resultsTitle(Director director) {
        String kind = director.progress().days().isEmpty() ? "nothing" : "results";
        return director.words().of("made.day." + kind);
    }

    @Override
    public List<List<String>> results(Director director) {
        List<List<String>> lines = new ArrayList<>();
        director.progress()
                .days()
                .forEach((day, result) -> lines.add(line(director.words(), day, result)));
        Collections.reverse(lines);
        return lines;
    }

    private static List<String> line(Words words, LocalDate day, DayResult result) {
        String time = words.number("%.2f", result.seconds());
        return List.of(
                written(words, day),
                words.of("made.clicks", result.clicks()),
                words.of("made.time", time));
    }

    /** All seeds of a day stand for that day. */
    @Override
    public Occasion of(Making.Made made) {
        return this;
    }

    @Override
    public Level named(Level level, Words words) {
        return level.called("day-" + date, new Wording(Map.of("en", title(words))));
    }

    @Override
    public Ledger ledger(Director director, Level level) {
        return new MadeLedger(level, game -> keep(director, game));
    }

    private void keep(Director director, PuzzleGame game) {
        DayResult result = new DayResult(game.clicks(), game.steps());
        director.progress(director.progress().solvedDay(date, result));
    }

    @Override
    public Optional<Occasion> next() {
        return Optional.empty();
    }

    /** A day is stored when it is solved, not when it is reached. */
    @Override
    public void reached(Director director) {}
}
