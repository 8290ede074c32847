/**
 * The scenes of the bench, each stated once for every engine, in our engine's definitions of bodies
 * and effects. SI units, y up.
 */
package rigibo.lab.bench.scene;
