package rigibo.frontend.puzzle.level;

import tools.jackson.databind.JsonNode;

import java.util.Map;

/**
 * A JSON document and where each of its values begins.
 *
 * @param root the document
 * @param places by JSON pointer; a member's place is that of its value
 */
public record LocatedJson(JsonNode root, Map<String, Place> places) {

    /** Where a value begins; that of the nearest value around it when there is none. */
    public Place at(String pointer) {
        String here = pointer;
        while (!here.isEmpty() && !places.containsKey(here)) {
            here = here.substring(0, here.lastIndexOf('/'));
        }
        return places.getOrDefault(here, Place.START);
    }

    /** The value at a pointer; a missing node where there is none. */
    public JsonNode node(String pointer) {
        return root.at(pointer);
    }
}
