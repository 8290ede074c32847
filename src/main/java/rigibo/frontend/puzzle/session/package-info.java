/**
 * The content of a level's screen: the player's own game or a recording in its place, paused or
 * slow, the poses at which its bodies are drawn, and the ghost of the best run. One frame is 1/60
 * s. Knows rules and recordings; draws nothing but the ghost.
 */
package rigibo.frontend.puzzle.session;
