/**
 * The panels around the play: the bar, keys, buttons, drawers, plates, the panel at the end, and
 * the lesson of a first level. {@code Panels} is its face. Knows the session and the placement of
 * the play; it decides nothing, but names the command of a click or key. Lengths in px of the
 * scene.
 */
package rigibo.frontend.puzzle.hud;
