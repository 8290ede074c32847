package rigibo.lab.precision.probe;

import rigibo.lab.engine.Work;
import rigibo.lab.problem.Errors;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What came out when an engine was put to a problem.
 *
 * @param errors how far from the truth it ended, or why it failed
 * @param steps made, of all worlds together
 * @param work what they did, counted
 * @param timing what they took; empty where it was not measured
 */
public record Finding(Errors errors, long steps, Work work, Optional<Timing> timing) {

    private static final String BETWEEN_FIELDS = "\t";
    private static final String BETWEEN_ERRORS = ";";
    private static final String AFTER_NAME = "=";
    private static final int FIELDS_WITHOUT_TIMING = 9;
    private static final int FIELDS = FIELDS_WITHOUT_TIMING + 6;

    /** Whether it came to an end, be it a failure; what broke off has nothing to be timed. */
    boolean hasRun() {
        return steps > 0;
    }

    /** The same and what it took. */
    Finding with(Timing took) {
        return new Finding(errors, steps, work, Optional.of(took));
    }

    /** All of it in one line, for a process to print and for a log. */
    public String line() {
        Stream<Object> told =
                Stream.of(
                        errors.main(),
                        others(),
                        errors.failure().replaceAll("\\s+", " "),
                        steps,
                        work.pairs(),
                        work.contacts(),
                        work.impacts(),
                        work.evaluations(),
                        work.rows());
        return Stream.concat(told, timing.stream().flatMap(Finding::fields))
                .map(String::valueOf)
                .collect(Collectors.joining(BETWEEN_FIELDS));
    }

    private String others() {
        return errors.others().entrySet().stream()
                .map(error -> error.getKey() + AFTER_NAME + error.getValue())
                .collect(Collectors.joining(BETWEEN_ERRORS));
    }

    private static Stream<Object> fields(Timing timing) {
        return Stream.of(
                timing.repeats(),
                timing.cpu(),
                timing.cpuLow(),
                timing.cpuHigh(),
                timing.wall(),
                timing.bytes());
    }

    /**
     * What a line says.
     *
     * @throws IllegalArgumentException when it is cut short or not such a line
     */
    public static Finding parse(String line) {
        String[] field = line.split(BETWEEN_FIELDS, -1);
        if (field.length != FIELDS && field.length != FIELDS_WITHOUT_TIMING) {
            throw new IllegalArgumentException("not a finding: '" + line + "'");
        }
        Errors errors = new Errors(Double.parseDouble(field[0]), parseOthers(field[1]), field[2]);
        Work work =
                new Work(
                        Long.parseLong(field[4]),
                        Long.parseLong(field[5]),
                        Long.parseLong(field[6]),
                        Long.parseLong(field[7]),
                        Long.parseLong(field[8]));
        return new Finding(errors, Long.parseLong(field[3]), work, parseTiming(field));
    }

    private static Map<String, Double> parseOthers(String text) {
        Map<String, Double> others = new LinkedHashMap<>();
        if (!text.isEmpty()) {
            for (String error : text.split(BETWEEN_ERRORS)) {
                int end = error.lastIndexOf(AFTER_NAME);
                others.put(error.substring(0, end), Double.valueOf(error.substring(end + 1)));
            }
        }
        return others;
    }

    private static Optional<Timing> parseTiming(String[] field) {
        if (field.length == FIELDS_WITHOUT_TIMING) {
            return Optional.empty();
        }
        double[] number = new double[FIELDS - FIELDS_WITHOUT_TIMING];
        for (int i = 0; i < number.length; i++) {
            number[i] = Double.parseDouble(field[FIELDS_WITHOUT_TIMING + i]);
        }
        return Optional.of(
                new Timing((int) number[0], number[1], number[2], number[3], number[4], number[5]));
    }
}
