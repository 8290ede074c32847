/**
 * Proves level files by playing them without a window: stored solutions win also when everything
 * starts a little aside, and no single click does. Knows levels, rules and the engine.
 */
package rigibo.frontend.puzzle.check;
