/**
 * Engines as the laboratory sees them, ours and those it is compared with: a few verbs that all of
 * them have. What a scene is, its bodies and effects, is said in our own words; an engine
 * translates them. SI units, y up.
 */
package rigibo.lab.engine;
