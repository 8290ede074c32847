/** The time of a step over the number of bodies, for our engine and others. */
package rigibo.lab.bench.crowd;
