/**
 * Random programs for the engine and mutated files for the game, for as long as is asked; names the
 * first that goes wrong. Knows the engine's public face and the game's readers, no window.
 */
package rigibo.fuzz;
