/**
 * What questions cost: rays among many discs, beside the engine that answers them fastest, and
 * sensors. Angles are rad, lengths m, times ns.
 */
package rigibo.lab.bench.query;
