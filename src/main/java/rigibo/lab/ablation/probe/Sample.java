package rigibo.lab.ablation.probe;

import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * What one process found.
 *
 * @param nanosPerStep of the processor, median over the periods after warm-up, ns
 * @param bytesPerStep allocated in the one of those periods that allocated least, bytes: all do the
 *     same, and what comes on top in some is what the compiler allocates on the thread it holds up
 * @param stateHash after the counted steps
 * @param counts of the counted steps: those of the first periods, the same however fast the machine
 * @param bitsPerBody the columns that the effects need, bits
 */
public record Sample(
        double nanosPerStep, double bytesPerStep, long stateHash, Counts counts, int bitsPerBody) {

    private static final int FIELDS = 9;

    /** All of it in one line, for a process to print and for a table. */
    public String line() {
        return Stream.of(
                        nanosPerStep,
                        bytesPerStep,
                        Long.toHexString(stateHash),
                        counts.pairs(),
                        counts.contacts(),
                        counts.impacts(),
                        counts.evaluations(),
                        counts.rows(),
                        bitsPerBody)
                .map(String::valueOf)
                .collect(Collectors.joining(","));
    }

    /**
     * What a line says.
     *
     * @throws IllegalArgumentException when it is cut short or not such a line
     */
    public static Sample parse(String line) {
        String[] field = line.split(",");
        if (field.length != FIELDS) {
            throw new IllegalArgumentException("not a sample: '" + line + "'");
        }
        Counts counts =
                new Counts(
                        Long.parseLong(field[3]),
                        Long.parseLong(field[4]),
                        Long.parseLong(field[5]),
                        Long.parseLong(field[6]),
                        Long.parseLong(field[7]));
        return new Sample(
                Double.parseDouble(field[0]),
                Double.parseDouble(field[1]),
                Long.parseUnsignedLong(field[2], 16),
                counts,
                Integer.parseInt(field[8]));
    }
}
