package rigibo.frontend.editor.desk;

import rigibo.frontend.document.Problem;
import rigibo.frontend.editor.draft.Draft;
import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.level.LevelLoader;
import rigibo.frontend.puzzle.level.LoadedLevel;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The problems of a draft: those found by reading it, at once, and those found by playing it last.
 */
public final class Inspection {

    private static final String NAME = "draft";

    private final LevelLoader loader = new LevelLoader();
    private Draft seen;
    private LoadedLevel loaded;
    private List<Problem> played = List.of();
    private Draft playedDraft;

    /** Inspects a draft, unless it is the last inspected one. */
    public void look(Draft draft) {
        if (draft != seen) {
            seen = draft;
            loaded = loader.parse(NAME, draft.toString());
        }
    }

    /** Takes the findings of playing a draft, which hold for that draft alone. */
    public void played(Draft draft, List<Problem> found) {
        playedDraft = draft;
        played = List.copyOf(found);
    }

    /** Whether the inspected draft has been played. */
    public boolean isPlayed() {
        return seen != null && seen.equals(playedDraft);
    }

    /** The level, if no error keeps it from being played. */
    public Optional<Level> level() {
        return loaded.level();
    }

    /** All problems, errors first. */
    public List<Finding> findings() {
        Stream<Problem> more = isPlayed() ? played.stream() : Stream.empty();
        List<Problem> all = Stream.concat(loaded.problems().stream(), more).distinct().toList();
        return Stream.concat(
                        all.stream().filter(Problem::isError),
                        all.stream().filter(problem -> !problem.isError()))
                .map(Finding::new)
                .toList();
    }

    /**
     * Number of errors, including those that are only counted; a draft with any of them is not
     * played.
     */
    public int errors() {
        int inPlay = isPlayed() ? (int) played.stream().filter(Problem::isError).count() : 0;
        return loaded.errors() + inPlay;
    }
}
