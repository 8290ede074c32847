/**
 * Tries random programs in the engine and mutated files in the game, and names the first that
 * fails. This room knows the engine's public face and the game's readers, but no window.
 */
package rigibo.fuzz;
