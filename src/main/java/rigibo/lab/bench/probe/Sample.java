package rigibo.lab.bench.probe;

import rigibo.lab.child.Work;

/**
 * The measurements of one process.
 *
 * @param steps number of timed steps
 * @param median median processor time of a step, ns
 * @param p99 99th percentile, ns
 * @param bytes median bytes allocated in a step
 * @param overlap deepest overlap at the end, m
 * @param height mean height of the bodies over their grounds at the end, as a share of that at the
 *     start: a crushed pile keeps less
 * @param energy energy of motion and height at the end, as a share of that at the start
 * @param work of all timed steps; none if the engine does not report it
 */
public record Sample(
        int steps,
        double median,
        double p99,
        double bytes,
        double overlap,
        double height,
        double energy,
        Work work) {}
