package rigibo.lab.bench.crowd;

/**
 * How long the steps of one flood took in one engine.
 *
 * @param engine name
 * @param bodies discs
 * @param median processor time of a step while the discs fall and settle, ms
 * @param p99 99th percentile, ms
 * @param deepest overlap at the end, as a share of a disc's radius: a run that is fast because
 *     discs sink does not count
 */
public record CrowdPoint(String engine, int bodies, double median, double p99, double deepest) {}
