/**
 * What lies on the editor's desk: the draft with its history, what is chosen, what is typed, what
 * was found wrong. Lengths in m. Draws nothing.
 */
package rigibo.frontend.editor.desk;
