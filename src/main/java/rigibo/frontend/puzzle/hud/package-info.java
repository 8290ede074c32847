/**
 * What lies around the play: the bar, keys, buttons, drawers, plates, the panel at the end, and the
 * lesson of a first level. {@code Panels} is its face. Knows the session and how the play is
 * placed; it decides nothing, but names the command that was meant. Lengths in px of the scene.
 */
package rigibo.frontend.puzzle.hud;
