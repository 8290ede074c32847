/**
 * Runs programs and judges what the engine makes of them, by laws that hold for every program:
 * nothing is thrown but refusals, refusals change nothing, states are finite, copies go on alike,
 * answers are those of a search through all bodies. Cuts down what breaks one. Knows the engine's
 * public face alone. SI units.
 */
package rigibo.fuzz.judge;
