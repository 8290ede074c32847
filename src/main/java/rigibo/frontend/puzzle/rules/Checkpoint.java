package rigibo.frontend.puzzle.rules;

/**
 * The state of a game between two steps, in one number.
 *
 * @param step how many steps had been done
 * @param hash of every bit that the future depends on
 */
public record Checkpoint(int step, long hash) {}
