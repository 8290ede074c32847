/**
 * Threads beside the page's own. They share nothing with it: an errand and what is told of it are
 * words. Knows nothing of the game.
 */
package rigibo.web.aside;
