package rigibo.frontend.puzzle.level;

/**
 * A click of a stored solution.
 *
 * @param seconds time since the start of the level, s
 * @param target id of the body or joint it acts on
 */
public record Click(double seconds, String target) {}
