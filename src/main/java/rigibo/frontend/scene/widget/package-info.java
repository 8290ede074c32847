/**
 * Buttons, sliders, toggles and readouts in a panel, for the demos' controls, by mouse and
 * keyboard.
 */
package rigibo.frontend.scene.widget;
