package rigibo.lab.precision.probe;

import rigibo.lab.problem.StepTally;

/**
 * The times of a step, without set-up and reading.
 *
 * @param repeats that were timed, after warming up: turns, each of the whole problem, once or more
 * @param cpu median over the repeats, µs of the thread's own processor time a step
 * @param cpuLow lower end of where that median lies with 95 %, µs
 * @param cpuHigh upper end, µs
 * @param wall median, µs a step by the clock on the wall
 * @param bytes allocated a step, median
 */
public record Timing(
        int repeats, double cpu, double cpuLow, double cpuHigh, double wall, double bytes) {

    /** The timing of a run that was timed only once. */
    static Timing of(StepTally tally) {
        double cpu = tally.cpuMicros();
        return new Timing(1, cpu, cpu, cpu, tally.wallMicros(), tally.bytesPerStep());
    }
}
