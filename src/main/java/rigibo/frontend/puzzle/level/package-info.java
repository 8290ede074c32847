/**
 * Levels as data: reads a level file, reports all its problems at once, and defines the records
 * that the rules use. Lengths in m, angles in rad (the files state degrees). Knows no drawing, no
 * window and no rules of play.
 */
package rigibo.frontend.puzzle.level;
