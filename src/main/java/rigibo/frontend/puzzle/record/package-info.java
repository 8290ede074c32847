/**
 * The record of a player's tries: counts, results and solved runs. Time counts in steps of 1/60 s.
 * Draws nothing.
 */
package rigibo.frontend.puzzle.record;
