package rigibo.lab.precision.probe;

/**
 * What a step took, set-up and reading left out.
 *
 * @param repeats that were timed, after warming up: turns, each of the whole problem, once or more
 * @param cpu median over the repeats, µs of the thread's own processor time a step
 * @param cpuLow lower end of where that median lies with 95 %, µs
 * @param cpuHigh upper end, µs
 * @param wall median, µs a step by the clock on the wall
 * @param bytes allocated a step, median
 */
public record Timing(
        int repeats, double cpu, double cpuLow, double cpuHigh, double wall, double bytes) {}
