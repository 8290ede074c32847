/**
 * The play as players see, hear and point at it: bodies, marks, particles, rings, cursor and
 * noises. It observes a session, and only {@code Table} is driven from outside. Lengths in m of the
 * world, or px where a name says so.
 */
package rigibo.frontend.puzzle.show;
