/**
 * The scenes of the bench, each stated once, in our own words for bodies and effects, for every
 * engine. They know no engine. SI units, y up.
 */
package rigibo.lab.bench.scene;
