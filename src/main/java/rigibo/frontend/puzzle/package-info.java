/**
 * The puzzle on the screen: a level in play and the level select. What counts is decided in {@code
 * rules}; here it is shown and made felt. Lengths in m of the world, or px of the logical 720 × 800
 * window where a name says so. Knows no OpenGL.
 */
package rigibo.frontend.puzzle;
