/** The page's window and loop, used with the game's own input, clock, curtain and toast. */
package rigibo.frontend.display;
