package rigibo.lab.bench.query;

import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.DoubleStream;

/**
 * What a process found.
 *
 * @param nanos by {@link Rays}: processor time of a ray, ns, the median of all runs
 * @param met by {@link Rays}: share of the way that rays go on average, by which engines are
 *     compared
 * @param sensing what sensors add to a step, ns; 0 where that was not asked
 */
record Answers(double[] nanos, double[] met, double sensing) {

    private static final String BETWEEN = " ";
    private static final int KINDS = Rays.values().length;

    /** In one line, for a process to print. */
    String line() {
        return DoubleStream.concat(
                        DoubleStream.concat(Arrays.stream(nanos), Arrays.stream(met)),
                        DoubleStream.of(sensing))
                .mapToObj(Double::toString)
                .collect(Collectors.joining(BETWEEN));
    }

    /**
     * What a line says.
     *
     * @throws IllegalArgumentException when it is cut short or not such a line
     */
    static Answers parse(String line) {
        double[] all =
                Arrays.stream(line.split(BETWEEN)).mapToDouble(Double::parseDouble).toArray();
        if (all.length != 2 * KINDS + 1) {
            throw new IllegalArgumentException("not answers: '" + line + "'");
        }
        return new Answers(
                Arrays.copyOf(all, KINDS),
                Arrays.copyOfRange(all, KINDS, 2 * KINDS),
                all[2 * KINDS]);
    }
}
