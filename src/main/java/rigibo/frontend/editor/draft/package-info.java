/**
 * A level in the making: an immutable {@link rigibo.frontend.editor.draft.Draft} whose edits are
 * functions that return a new one. It holds the level's document itself, so that members unknown to
 * the editor survive. Lengths in m, angles in degrees as in level files. Knows no window and no
 * drawing.
 */
package rigibo.frontend.editor.draft;
