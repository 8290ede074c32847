package rigibo.frontend.puzzle.level;

import tools.jackson.databind.JsonNode;

/**
 * A click of a stored solution.
 *
 * @param seconds time since the start of the level, s
 * @param target id of the body or joint it acts on
 */
public record Click(double seconds, String target) {

    /** The id that a click of a file names, of a body or of a joint; empty if it names none. */
    public static String targetIn(JsonNode click) {
        return click.path(click.has("joint") ? "joint" : "body").asString("");
    }
}
