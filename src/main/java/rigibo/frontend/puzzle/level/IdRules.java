package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Document;
import rigibo.frontend.document.Place;
import rigibo.frontend.document.Suggestion;

import tools.jackson.databind.JsonNode;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** E101 an id used twice; E102 a reference to an unknown one. */
final class IdRules {

    private IdRules() {}

    static void check(LevelSketch sketch) {
        Map<String, String> ids = uniqueIds(sketch.json());
        for (Located<Solution> solution : sketch.solutions()) {
            List<Click> clicks = solution.part().clicks();
            for (int i = 0; i < clicks.size(); i++) {
                String body = clicks.get(i).body();
                if (!ids.containsKey(body)) {
                    String pointer = solution.pointer() + "/clicks/" + i + "/body";
                    sketch.json()
                            .error(
                                    pointer,
                                    () ->
                                            "E102 no body has the id \""
                                                    + body
                                                    + "\""
                                                    + Suggestion.among(ids.keySet(), body));
                }
            }
        }
    }

    /**
     * Where each id is stated first, as a pointer. Also of bodies with errors elsewhere, or each
     * reference to them would be one more error.
     */
    private static Map<String, String> uniqueIds(Document json) {
        Map<String, String> ids = new HashMap<>();
        for (int i = 0; i < json.node("/bodies").size(); i++) {
            String pointer = "/bodies/" + i + "/id";
            JsonNode id = json.node(pointer);
            if (id.isString()) {
                String first = ids.putIfAbsent(id.asString(), pointer);
                if (first != null) {
                    json.error(pointer, () -> twice(id, json.at(first)));
                }
            }
        }
        return ids;
    }

    private static String twice(JsonNode id, Place first) {
        return "E101 body id " + id + " is used twice (first at " + first + ")";
    }
}
