package rigibo.lab.bench;

import rigibo.lab.bench.probe.Sample;

/**
 * The result of a process.
 *
 * @param scene name
 * @param engine name
 * @param round from 1 on
 * @param sample the measurement
 */
record Run(String scene, String engine, int round, Sample sample) {}
