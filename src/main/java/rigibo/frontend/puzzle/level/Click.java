package rigibo.frontend.puzzle.level;

/**
 * A click of a stored solution.
 *
 * @param seconds time since the start of the level, s
 * @param body id of the body it deletes
 */
public record Click(double seconds, String body) {}
