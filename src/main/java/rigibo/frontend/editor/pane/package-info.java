/**
 * The panes around the draft: tools, fields, effects, problems, files to open. They are drawn in
 * every frame, and register the effect of a press on them while they are drawn. Coordinates are
 * logical pixels.
 */
package rigibo.frontend.editor.pane;
