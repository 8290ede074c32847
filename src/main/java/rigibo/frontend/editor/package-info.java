/**
 * Makes levels: place, drag, turn, size, try, save. It writes the files that the game and {@code
 * levels check} read. Knows levels, rules, their check, and the puzzle's scene that plays a draft;
 * no window and no OpenGL.
 */
package rigibo.frontend.editor;
