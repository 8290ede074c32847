package rigibo.frontend.scene;

import java.util.Collections;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * A player's progress in all levels; immutable. A changed value is passed to {@link
 * Director#progress(Progress)}.
 *
 * @param levels by the level's id, in its order
 */
public record Progress(SortedMap<String, LevelProgress> levels) {

    public Progress {
        levels = Collections.unmodifiableSortedMap(new TreeMap<>(levels));
    }

    /** Nothing yet. */
    public static Progress none() {
        return new Progress(Collections.emptySortedMap());
    }

    /**
     * What was done in a level.
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

    /** After a try at a level that was lost. */
    public Progress failed(String id, long hash) {
        return with(id, of(id, hash).failed());
    }

    private Progress with(String id, LevelProgress level) {
        SortedMap<String, LevelProgress> changed = new TreeMap<>(levels);
        changed.put(id, level);
        return new Progress(changed);
    }

    /** Together with what was done elsewhere. */
    public Progress with(Progress other) {
        SortedMap<String, LevelProgress> all = new TreeMap<>(levels);
        other.levels.forEach((id, level) -> all.merge(id, level, LevelProgress::with));
        return new Progress(all);
    }
}
