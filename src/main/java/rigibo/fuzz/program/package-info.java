/**
 * Programs for the engine, drawn from a seed: a set of effects, an accuracy, and calls of every
 * public verb, in any order, with numbers of any size. Each call is also told as Java, so that a
 * program that went wrong can be pasted into a test. Knows the engine's public face, judges
 * nothing. SI units.
 */
package rigibo.fuzz.program;
