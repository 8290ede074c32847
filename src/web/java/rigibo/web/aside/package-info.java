/**
 * Threads beside the page's own. They share no memory with it: errands and reports are words. Knows
 * nothing of the game.
 */
package rigibo.web.aside;
