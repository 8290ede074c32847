/**
 * The pointer's tools: selecting and dragging, drawing boxes and discs, setting corners. Points are
 * in the world, m.
 */
package rigibo.frontend.editor.tool;
