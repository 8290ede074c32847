/**
 * The game as a page: what it has brought along as files, what of the player the browser keeps, and
 * the scenes that can be chosen there. Knows the document and the frontend.
 */
package rigibo.web.game;
