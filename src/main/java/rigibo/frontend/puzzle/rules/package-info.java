/**
 * The rules of the puzzle, without drawing: time counts in steps of 1/60 s, and the same clicks at
 * the same steps give the same bits. Knows levels and the engine's public face, nothing else.
 */
package rigibo.frontend.puzzle.rules;
