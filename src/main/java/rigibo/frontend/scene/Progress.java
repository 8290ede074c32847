package rigibo.frontend.scene;

import java.time.LocalDate;
import java.util.Collections;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * A player's progress: in the levels of the game, the daily levels and the endless ones; immutable.
 * A changed value is passed to {@link Director#progress(Progress)}.
 *
 * @param levels by the level's id, in its order
 * @param days the best game at each daily level that was solved, by date
 * @param endless number of the next endless level, from 1
 * @param totals of all levels together
 */
public record Progress(
        SortedMap<String, LevelProgress> levels,
        SortedMap<LocalDate, DayResult> days,
        int endless,
        Totals totals) {

    public Progress {
        if (endless < 1) {
            throw new IllegalArgumentException(
                    "Progress.endless must be 1 or more, was " + endless);
        }
        levels = Collections.unmodifiableSortedMap(new TreeMap<>(levels));
        days = Collections.unmodifiableSortedMap(new TreeMap<>(days));
    }

    /** Nothing yet. */
    public static Progress none() {
        return new Progress(
                Collections.emptySortedMap(), Collections.emptySortedMap(), 1, Totals.NONE);
    }

    /**
     * The progress in a level.
     *
     * @param id of the level
     * @param hash of the level as it is now
     */
    public LevelProgress of(String id, long hash) {
        LevelProgress known = levels.get(id);
        return known == null ? LevelProgress.none(hash) : known.in(hash);
    }

    /** After a try that solved a level with a number of clicks. */
    public Progress solved(String id, long hash, int clicks) {
        return with(id, of(id, hash).solved(clicks));
    }

    /** After a try that earned the secret star of a level, which it has solved. */
    public Progress starred(String id, long hash) {
        return with(id, of(id, hash).starred());
    }

    /** After a try at a level that was lost. */
    public Progress failed(String id, long hash) {
        return with(id, of(id, hash).failed());
    }

    private Progress with(String id, LevelProgress level) {
        SortedMap<String, LevelProgress> changed = new TreeMap<>(levels);
        changed.put(id, level);
        return new Progress(changed, days, endless, totals);
    }

    /** After a game that solved the level of a day. */
    public Progress solvedDay(LocalDate date, DayResult result) {
        SortedMap<LocalDate, DayResult> changed = new TreeMap<>(days);
        changed.merge(date, result, DayResult::best);
        return new Progress(levels, changed, endless, totals);
    }

    /** A copy with the given number as the next endless level; it never goes back. */
    public Progress endless(int next) {
        return new Progress(levels, days, Math.max(endless, next), totals);
    }

    /** After more of everything that is counted in all levels together. */
    public Progress played(Totals more) {
        return withTotals(totals.plus(more));
    }

    /** Returns this progress with other totals. */
    public Progress withTotals(Totals other) {
        return new Progress(levels, days, endless, other);
    }

    /**
     * Merges progress made elsewhere. Totals stay as they are here, since both may have counted the
     * same tries.
     */
    public Progress with(Progress other) {
        SortedMap<String, LevelProgress> all = new TreeMap<>(levels);
        other.levels.forEach((id, level) -> all.merge(id, level, LevelProgress::with));
        SortedMap<LocalDate, DayResult> allDays = new TreeMap<>(days);
        other.days.forEach((date, result) -> allDays.merge(date, result, DayResult::best));
        return new Progress(all, allDays, Math.max(endless, other.endless), totals);
    }
}
