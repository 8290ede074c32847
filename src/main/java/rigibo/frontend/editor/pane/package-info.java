/**
 * The editor's panes round the draft: tools, fields, effects, what is wrong, files to open. They
 * are drawn anew each frame and name, while they are drawn, what a press on them does. Coordinates
 * are logical pixels.
 */
package rigibo.frontend.editor.pane;
