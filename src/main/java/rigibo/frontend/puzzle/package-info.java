/**
 * The puzzle on the screen: a level in play and the level select. The room {@code rules} decides
 * the game; this one shows it. Lengths in m of the world, or px of the logical 720 × 800 scene
 * where a name says so. Knows no OpenGL.
 */
package rigibo.frontend.puzzle;
