package rigibo.frontend.puzzle.rules;

/**
 * A click that did something.
 *
 * @param step number of steps done before it
 * @param target id of the body or joint that was clicked
 */
public record Act(int step, String target) {}
