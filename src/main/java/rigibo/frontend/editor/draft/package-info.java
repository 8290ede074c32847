/**
 * A level while it is made: an immutable {@link rigibo.frontend.editor.draft.Draft} whose edits are
 * functions that give another one. It is the level's document itself, so that what the editor does
 * not know of survives. Lengths in m, angles in degrees as in level files. Knows no window and no
 * drawing.
 */
package rigibo.frontend.editor.draft;
