/**
 * What mechanics says of simple scenes: the truths that hard cases and reference problems share. It
 * knows no engine: states are handed in as numbers, bodies out as definitions. SI units, y up.
 */
package rigibo.lab.truth;
