package rigibo.lab.bench.probe;

import rigibo.lab.engine.Work;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What one process found.
 *
 * @param steps timed
 * @param median of the processor time of a step, ns
 * @param p99 99th percentile of it, ns
 * @param bytes allocated in a step, median
 * @param overlap the deepest at the end, m
 * @param height mean height of the bodies over their grounds at the end, as a share of what it was
 *     as the scene began: a pile that is crushed keeps less
 * @param energy of motion and height at the end, as a share of what it was as the scene began
 * @param work of all timed steps; nothing where the engine does not tell
 */
public record Sample(
        int steps,
        double median,
        double p99,
        double bytes,
        double overlap,
        double height,
        double energy,
        Work work) {

    /** The names of the fields of {@link #fields}. */
    public static final List<String> FIELDS =
            List.of(
                    "steps",
                    "median_ns",
                    "p99_ns",
                    "bytes_per_step",
                    "deepest_overlap_m",
                    "height_kept",
                    "energy_kept",
                    "pairs",
                    "contacts",
                    "impacts",
                    "evaluations",
                    "rows");

    /** How many of the last fields count work. */
    public static final int WORK_FIELDS = 5;

    private static final String BETWEEN = ",";

    /** All of it, for tables. */
    public List<Object> fields() {
        return List.of(
                steps,
                median,
                p99,
                bytes,
                overlap,
                height,
                energy,
                work.pairs(),
                work.contacts(),
                work.impacts(),
                work.evaluations(),
                work.rows());
    }

    /** All of it in one line, for a process to print. */
    public String line() {
        return fields().stream().map(String::valueOf).collect(Collectors.joining(BETWEEN));
    }

    /**
     * What a line says.
     *
     * @throws IllegalArgumentException when it is cut short or not such a line
     */
    public static Sample parse(String line) {
        String[] field = line.split(BETWEEN, -1);
        if (field.length != FIELDS.size()) {
            throw new IllegalArgumentException("not a sample: '" + line + "'");
        }
        long[] work =
                Stream.of(field)
                        .skip(field.length - WORK_FIELDS)
                        .mapToLong(Long::parseLong)
                        .toArray();
        return new Sample(
                Integer.parseInt(field[0]),
                Double.parseDouble(field[1]),
                Double.parseDouble(field[2]),
                Double.parseDouble(field[3]),
                Double.parseDouble(field[4]),
                Double.parseDouble(field[5]),
                Double.parseDouble(field[6]),
                new Work(work[0], work[1], work[2], work[3], work[4]));
    }
}
