/**
 * Random programs for the engine: a set of effects, an accuracy, and calls of every public verb, in
 * any order, with numbers of any size. Each call is also written as Java, so that a failing program
 * can be pasted into a test. This room knows the engine's public face and checks nothing. SI units.
 */
package rigibo.fuzz.program;
