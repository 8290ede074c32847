/**
 * The rules of the puzzle, without drawing: time counts in steps of 1/60 s, and the same clicks at
 * the same steps give the same bits. Knows levels, the engine's public face, and the line along
 * which a rope is drawn, nothing else.
 */
package rigibo.frontend.puzzle.rules;
