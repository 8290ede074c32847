/**
 * The cost of queries: rays among many discs, compared with the fastest other engine, and sensors.
 * Angles are in rad, lengths in m, times in ns.
 */
package rigibo.lab.bench.query;
