/**
 * Makes levels: place, drag, turn, size, try, save. What it makes are the files that the game and
 * {@code levels check} read. Sees levels, rules, their check and the puzzle's scene, which plays
 * what is made; no window and no OpenGL.
 */
package rigibo.frontend.editor;
