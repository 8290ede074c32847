package rigibo.frontend.puzzle.level;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/** Collects the problems of one file, so that all of them are told at once. */
public final class Problems {

    private static final Comparator<Problem> IN_READING_ORDER =
            Comparator.comparingInt((Problem problem) -> problem.place().line())
                    .thenComparingInt(problem -> problem.place().column());

    private final String file;
    private final List<Problem> found = new ArrayList<>();

    public Problems(String file) {
        this.file = file;
    }

    /** Something that keeps the level from being played. */
    public void error(Place place, String pointer, String message) {
        found.add(new Problem(Problem.Severity.ERROR, file, place, pointer, message));
    }

    /** Something that is probably not meant. */
    public void warning(Place place, String pointer, String message) {
        found.add(new Problem(Problem.Severity.WARNING, file, place, pointer, message));
    }

    public boolean hasErrors() {
        return found.stream().anyMatch(Problem::isError);
    }

    /** Whether an error lies at this pointer or below it. */
    public boolean spoil(String pointer) {
        return found.stream()
                .filter(Problem::isError)
                .map(Problem::pointer)
                .anyMatch(at -> at.equals(pointer) || at.startsWith(pointer + "/"));
    }

    /** In the order in which a reader of the file meets them. */
    public List<Problem> inOrder() {
        return found.stream().sorted(IN_READING_ORDER).toList();
    }
}
