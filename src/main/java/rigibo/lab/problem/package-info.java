/**
 * The reference problems: scenes whose truth is known, stated once for every engine and every
 * accuracy. Each class derives its truth in its comment. SI units.
 */
package rigibo.lab.problem;
