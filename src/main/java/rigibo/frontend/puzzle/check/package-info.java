/**
 * Plays levels without a window to see that they can be solved, and not by luck: stored solutions
 * must win at every accuracy and in a sample of games with everything a little aside; a search over
 * orders and times of clicks, all of them or a sample, must find none that wins with fewer than par
 * and tells how often others do. Time counts in steps of 1/60 s. Knows levels, rules, the presets
 * of accuracy and the engine.
 */
package rigibo.frontend.puzzle.check;
