package rigibo.lab.precision.probe;

import rigibo.lab.problem.StepTally;

/**
 * The times of a step, without set-up and reading.
 *
 * @param repeats number of timed repeats after warming up, each of the whole problem once or more
 * @param cpu median over the repeats of the thread's processor time per step, µs
 * @param cpuLow lower end of the median's 95 % interval, µs
 * @param cpuHigh upper end of that interval, µs
 * @param wall median time per step by the wall clock, µs
 * @param bytes median bytes allocated per step
 */
public record Timing(
        int repeats, double cpu, double cpuLow, double cpuHigh, double wall, double bytes) {

    /** The timing of a run that was timed only once. */
    static Timing of(StepTally tally) {
        double cpu = tally.cpuMicros();
        return new Timing(1, cpu, cpu, cpu, tally.wallMicros(), tally.bytesPerStep());
    }
}
