/**
 * Pictures of measurements, as SVG and as PNG, and the scales, marks and labels that figures share.
 * This room knows nothing of what is measured. Lengths are px of a picture, y down. AWT is used
 * here alone, without a display.
 */
package rigibo.lab.plot;
