/**
 * The state of the editor's desk: the draft with its history, the selection, the text being typed,
 * the problems found. Lengths in m. Draws nothing.
 */
package rigibo.frontend.editor.desk;
