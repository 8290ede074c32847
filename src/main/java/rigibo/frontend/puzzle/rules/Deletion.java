package rigibo.frontend.puzzle.rules;

/**
 * A click that deleted a body.
 *
 * @param step number of steps done before it
 * @param body id of the body
 */
public record Deletion(int step, String body) {}
