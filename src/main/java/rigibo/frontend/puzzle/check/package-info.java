/**
 * Plays levels without a window to prove that they can be solved, and not by luck. Stored solutions
 * must win at every accuracy, and in a sample of games with small variations. A search over orders
 * and times of clicks, complete or sampled, must find no win with fewer clicks than par, and
 * reports how often others win. Time counts in steps of 1/60 s. Knows levels, rules, the presets of
 * accuracy and the engine.
 */
package rigibo.frontend.puzzle.check;
