package rigibo.frontend.document;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;

/** Collects the problems of one file: the first hundred are reported, the others counted. */
public final class Problems {

    /** Nobody mends more at once, and each that is told is looked up in the file. */
    static final int MOST_TOLD = 100;

    private static final Comparator<Problem> IN_READING_ORDER =
            Comparator.comparingInt((Problem problem) -> problem.place().line())
                    .thenComparingInt(problem -> problem.place().column());

    private final String file;
    private final List<Problem> told = new ArrayList<>();
    private int untold;
    private int errors;

    /**
     * None yet.
     *
     * @param file what messages call it
     */
    public Problems(String file) {
        this.file = file;
    }

    /** Something that keeps the file from being used. */
    public void error(Place place, String pointer, String message) {
        tell(Problem.Severity.ERROR, place, pointer, message);
    }

    void tell(Problem.Severity severity, Place place, String pointer, String message) {
        if (isFull()) {
            count(severity);
        } else {
            told.add(new Problem(severity, file, place, pointer, message));
            errors += severity == Problem.Severity.ERROR ? 1 : 0;
        }
    }

    /** One more that is not told. */
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

    /** How many of them are errors. */
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

    /** In the order in which a reader of the file meets them; at last, how many are not told. */
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
        String words = String.format(Locale.ROOT, "… and %,d more", untold);
        return new Problem(severity, file, last, "", words);
    }
}
