package rigibo.lab.bench.crowd;

/**
 * How long the steps of one flood took in one engine.
 *
 * @param engine name
 * @param bodies discs
 * @param median ms of the processor a step, while they fall and settle
 * @param p99 99th percentile, ms
 * @param deepest overlap at the end, as a share of a disc's radius: a fast run that sinks is no run
 */
public record CrowdPoint(String engine, int bodies, double median, double p99, double deepest) {}
