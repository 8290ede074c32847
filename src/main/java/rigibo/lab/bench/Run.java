package rigibo.lab.bench;

import rigibo.lab.bench.probe.Sample;

/**
 * What a process found.
 *
 * @param scene name
 * @param engine name
 * @param round from 1 on
 * @param sample it
 */
record Run(String scene, String engine, int round, Sample sample) {}
