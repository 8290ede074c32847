/**
 * Pictures of what was measured: what can be drawn, drawn as SVG and as PNG, and the scales, marks
 * and labels that figures share. It knows nothing of what is measured. Lengths are px of a picture,
 * y down. Here alone is AWT used, without a display.
 */
package rigibo.lab.plot;
