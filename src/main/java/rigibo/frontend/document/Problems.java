package rigibo.frontend.document;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** Collects the problems of one file: the first hundred are reported, the others counted. */
public final class Problems {

    /**
     * Most problems that are reported. Nobody mends more at once, and the place of each has to be
     * searched for in the file.
     */
    static final int MOST_TOLD = 100;

    private static final Comparator<Problem> IN_READING_ORDER =
            Comparator.comparingInt((Problem problem) -> problem.place().line())
                    .thenComparingInt(problem -> problem.place().column());

    private final String file;
    private final List<Problem> told = new ArrayList<>();
    private int untold;
    private int errors;

    /**
     * Makes an empty list.
     *
     * @param file what messages call it
     */
    public Problems(String file) {
        this.file = file;
    }

    /** Reports an error, which keeps the file from being used. */
    void error(Place place, String pointer, Fault fault) {
        tell(Problem.Severity.ERROR, Cause.CONTENT, place, pointer, fault);
    }

    void error(Cause cause, Place place, String pointer, String message) {
        tell(Problem.Severity.ERROR, cause, place, pointer, Fault.plain(message));
    }

    /** Reports why a file as a whole cannot be used. */
    void refuse(Cause cause, String message) {
        error(cause, Place.START, "", message);
    }

    void tell(Problem.Severity severity, Cause cause, Place place, String pointer, Fault fault) {
        if (isFull()) {
            count(severity);
        } else {
            told.add(new Problem(severity, file, place, pointer, fault, cause));
            errors += severity == Problem.Severity.ERROR ? 1 : 0;
        }
    }

    /** Counts a problem that is not reported. */
    void count(Problem.Severity severity) {
        untold++;
        errors += severity == Problem.Severity.ERROR ? 1 : 0;
    }

    boolean isFull() {
        return told.size() == MOST_TOLD;
    }

    boolean hasUntold() {
        return untold > 0;
    }

    /** Whether one of them is an error. */
    public boolean hasErrors() {
        return errors > 0;
    }

    /** Number of errors. */
    public int errors() {
        return errors;
    }

    Set<String> pointers() {
        return told.stream().map(Problem::pointer).collect(Collectors.toSet());
    }

    boolean spoil(String pointer) {
        return told.stream()
                .filter(Problem::isError)
                .map(Problem::pointer)
                .anyMatch(at -> at.equals(pointer) || at.startsWith(pointer + "/"));
    }

    /**
     * The problems in the order in which they stand in the file, followed by how many are not
     * reported.
     */
    public List<Problem> inOrder() {
        List<Problem> ordered = new ArrayList<>(told);
        ordered.sort(IN_READING_ORDER);
        if (hasUntold()) {
            ordered.add(rest(ordered.get(ordered.size() - 1).place()));
        }
        return List.copyOf(ordered);
    }

    private Problem rest(Place last) {
        Problem.Severity severity = hasErrors() ? Problem.Severity.ERROR : Problem.Severity.WARNING;
        return new Problem(severity, file, last, "", Fault.of("rest", "… and %,d more", untold));
    }
}
