/**
 * Why levels are made by chance, of the day or one after the other: their seeds, their making on a
 * thread of its own, and what is kept of their results. Knows no scene: the room above shows and
 * plays what is made.
 */
package rigibo.frontend.puzzle.endless;
