package rigibo.lab.bench.probe;

import rigibo.lab.child.Work;

/**
 * What one process found.
 *
 * @param steps timed
 * @param median of the processor time of a step, ns
 * @param p99 99th percentile of it, ns
 * @param bytes allocated in a step, median
 * @param overlap the deepest at the end, m
 * @param height mean height of the bodies over their grounds at the end, as a share of what it was
 *     as the scene began: a pile that is crushed keeps less
 * @param energy of motion and height at the end, as a share of what it was as the scene began
 * @param work of all timed steps; nothing where the engine does not tell
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
