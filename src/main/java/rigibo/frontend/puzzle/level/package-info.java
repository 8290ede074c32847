/**
 * Levels as data: reading a level file, telling everything that is wrong with it at once, and the
 * records that the rules play by. Lengths in m, angles in rad (the files state degrees). Knows no
 * drawing, no window and no rules of play.
 */
package rigibo.frontend.puzzle.level;
