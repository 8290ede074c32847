/**
 * An interface that our engine and those compared with it share, with the few verbs that all of
 * them have. Scenes are stated in our engine's definitions of bodies and effects; each engine
 * translates them. SI units, y up.
 */
package rigibo.lab.engine;
