/**
 * Plays levels without a window to prove that they can be solved, and not by luck: stored solutions
 * must win at every accuracy and with everything a little aside, fewer clicks than par must not,
 * and a search over orders and times of clicks tells how often others do. Time counts in steps of
 * 1/60 s. Knows levels, rules, the presets of accuracy and the engine.
 */
package rigibo.frontend.puzzle.check;
