/**
 * The page's window and loop, beside which the game's own input, clock, curtain and toast stand.
 */
package rigibo.frontend.display;
