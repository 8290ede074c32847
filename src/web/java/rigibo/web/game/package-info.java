/**
 * The game as a page: its files, the player's files in the browser, and the scenes. Knows the
 * document and the frontend.
 */
package rigibo.web.game;
