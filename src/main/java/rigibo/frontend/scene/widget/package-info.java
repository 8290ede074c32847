/**
 * Buttons, sliders, toggles and readouts in a panel, for the demos' controls. Mouse and keyboard.
 */
package rigibo.frontend.scene.widget;
