package rigibo.lab.bench.moving;

import rigibo.lab.bench.probe.StepTimes;

import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;

/**
 * How a scene went in one engine.
 *
 * @param nanos processor time of each step, the median of several runs, ns
 * @param contacts of each step; empty where the engine does not tell
 * @param lastMoving the last step after which a body was faster than counts as still; −1 where none
 * @param deepest overlap after any step, in widths of the smaller body
 * @param left overlap after the last step, likewise
 * @param gain greatest energy beyond the start's, as a share of it, while nothing is driven; NaN
 *     where something is
 * @param bytes allocated in a step, median
 * @param jointError the most that a joint was off after any step, m
 */
record Course(
        double[] nanos,
        double[] contacts,
        int lastMoving,
        double deepest,
        double left,
        double gain,
        double bytes,
        double jointError) {

    private static final String BETWEEN = "\t";
    private static final String BETWEEN_STEPS = " ";
    private static final int FIELDS = 8;

    /** In one line, for a process to print. */
    String line() {
        return String.join(
                BETWEEN,
                words(nanos),
                words(contacts),
                "" + lastMoving,
                "" + deepest,
                "" + left,
                "" + gain,
                "" + bytes,
                "" + jointError);
    }

    private static String words(double[] values) {
        return DoubleStream.of(values)
                .mapToObj(value -> "" + Math.round(value))
                .collect(Collectors.joining(BETWEEN_STEPS));
    }

    /**
     * What a line says.
     *
     * @throws IllegalArgumentException when it is cut short or not such a line
     */
    static Course parse(String line) {
        String[] field = line.split(BETWEEN, -1);
        if (field.length != FIELDS) {
            throw new IllegalArgumentException("not a course: '" + line + "'");
        }
        return new Course(
                values(field[0]),
                values(field[1]),
                Integer.parseInt(field[2]),
                Double.parseDouble(field[3]),
                Double.parseDouble(field[4]),
                Double.parseDouble(field[5]),
                Double.parseDouble(field[6]),
                Double.parseDouble(field[7]));
    }

    private static double[] values(String words) {
        return words.isEmpty()
                ? new double[0]
                : Arrays.stream(words.split(BETWEEN_STEPS))
                        .mapToDouble(Double::parseDouble)
                        .toArray();
    }

    /** StepTimes of the first steps. */
    StepTimes times(int steps) {
        return new StepTimes(Arrays.copyOf(nanos, Math.min(steps, nanos.length)));
    }

    /**
     * StepTimes of those of the first steps that have at least half of the most contacts: what an
     * even step of a heap takes.
     */
    StepTimes busyTimes(int steps) {
        int count = Math.min(steps, contacts.length);
        double most = Arrays.stream(contacts, 0, count).max().orElse(0);
        double[] busy = new double[count];
        int found = 0;
        for (int i = 0; i < count; i++) {
            if (contacts[i] >= most / 2) {
                busy[found++] = nanos[i];
            }
        }
        return new StepTimes(Arrays.copyOf(busy, found));
    }
}
