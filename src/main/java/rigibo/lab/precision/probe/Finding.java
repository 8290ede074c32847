package rigibo.lab.precision.probe;

import rigibo.lab.child.Fields;
import rigibo.lab.child.Work;
import rigibo.lab.problem.Errors;

import java.util.Optional;

/**
 * The result of an engine at a problem.
 *
 * @param errors errors of the run, or why it failed
 * @param steps number of steps, of all worlds together
 * @param work counted work of these steps
 * @param timing times of the steps; empty if they were not measured
 */
public record Finding(Errors errors, long steps, Work work, Optional<Timing> timing) {

    private static final String BEFORE_TIMING = "\ttimed\t";

    /** The fields of every run, timed or not. */
    private record Untimed(Errors errors, long steps, Work work) {}

    /** Whether the run came to an end, even a failed one; a run that broke off cannot be timed. */
    boolean hasRun() {
        return steps > 0;
    }

    /** A copy with its timing. */
    Finding with(Timing took) {
        return new Finding(errors, steps, work, Optional.of(took));
    }

    /** The finding as one line, for a process to print and for a log. */
    public String line() {
        String failure = errors.failure().replaceAll("\\s+", " ");
        Errors onOneLine = new Errors(errors.main(), errors.others(), failure);
        String untimed = Fields.line(new Untimed(onOneLine, steps, work));
        return timing.map(took -> untimed + BEFORE_TIMING + Fields.line(took)).orElse(untimed);
    }

    /**
     * Parses a line of {@link #line}.
     *
     * @throws IllegalArgumentException when it is cut short or not such a line
     */
    public static Finding parse(String line) {
        String[] parts = line.split(BEFORE_TIMING, 2);
        Untimed found = Fields.parse(Untimed.class, parts[0]);
        Optional<Timing> timing =
                parts.length == 1
                        ? Optional.empty()
                        : Optional.of(Fields.parse(Timing.class, parts[1]));
        return new Finding(found.errors, found.steps, found.work, timing);
    }
}
