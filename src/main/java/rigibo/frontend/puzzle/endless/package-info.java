/**
 * The occasions on which levels are made by chance, the day or the next in a row: their seeds,
 * their making on a thread of its own, and the record of their results. Knows no scene; the room
 * above shows and plays the levels.
 */
package rigibo.frontend.puzzle.endless;
