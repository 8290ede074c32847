package rigibo.lab.bench.crowd;

/**
 * A flood of so many discs.
 *
 * @param engine name
 * @param bodies discs
 * @param median ms of the processor a step, while they fall and settle
 * @param p99 99th percentile, ms
 * @param deepest overlap at the end, as a share of a disc's radius: a fast run that sinks is no run
 */
public record CrowdPoint(String engine, int bodies, double median, double p99, double deepest) {

    private static final String BETWEEN = "\t";

    String line() {
        return String.join(BETWEEN, engine, "" + bodies, "" + median, "" + p99, "" + deepest);
    }

    static CrowdPoint parse(String line) {
        String[] field = line.split(BETWEEN);
        return new CrowdPoint(
                field[0],
                Integer.parseInt(field[1]),
                Double.parseDouble(field[2]),
                Double.parseDouble(field[3]),
                Double.parseDouble(field[4]));
    }
}
