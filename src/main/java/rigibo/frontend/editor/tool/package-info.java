/**
 * What the pointer does on the draft: choosing and dragging, drawing out boxes and discs, setting
 * corners. Points are in the world, m.
 */
package rigibo.frontend.editor.tool;
