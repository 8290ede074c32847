package rigibo.frontend.puzzle.rules;

/**
 * The state of a game between two steps, as one hash.
 *
 * @param step number of steps made before
 * @param hash of every bit that decides the future
 */
public record Checkpoint(int step, long hash) {}
