/** The main menu: leads to the game and the demos. */
package rigibo.frontend.menu;
