package rigibo.frontend.puzzle.level;

/**
 * A click of a stored solution.
 *
 * @param seconds since the level began
 * @param body id of the body it deletes
 */
public record Click(double seconds, String body) {}
