/**
 * The truths that hard cases and reference problems share. They know no engine: states come in as
 * numbers, and bodies go out as definitions. SI units, y up.
 */
package rigibo.lab.truth;
