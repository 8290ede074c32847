package rigibo.frontend.puzzle.rules;

/**
 * A click that had an effect.
 *
 * @param step number of steps made before it
 * @param target id of the body or joint that was clicked
 */
public record Act(int step, String target) {}
