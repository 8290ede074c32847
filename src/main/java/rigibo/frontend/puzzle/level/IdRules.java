package rigibo.frontend.puzzle.level;

import tools.jackson.databind.JsonNode;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** E101 an id used twice; E102 a reference to an unknown one. */
final class IdRules {

    private IdRules() {}

    static void check(LevelSketch sketch, Problems problems) {
        Map<String, Place> ids = uniqueIds(sketch.json(), problems);
        for (Located<Solution> solution : sketch.solutions()) {
            List<Click> clicks = solution.part().clicks();
            for (int i = 0; i < clicks.size(); i++) {
                String body = clicks.get(i).body();
                if (!ids.containsKey(body)) {
                    String pointer = solution.pointer() + "/clicks/" + i + "/body";
                    problems.error(
                            sketch.json().at(pointer),
                            pointer,
                            "E102 no body has the id \""
                                    + body
                                    + "\""
                                    + Suggestion.among(ids.keySet(), body));
                }
            }
        }
    }

    /** Also of bodies with errors elsewhere, or each reference to them would be one more error. */
    private static Map<String, Place> uniqueIds(LocatedJson json, Problems problems) {
        Map<String, Place> ids = new HashMap<>();
        for (int i = 0; i < json.node("/bodies").size(); i++) {
            String pointer = "/bodies/" + i + "/id";
            JsonNode id = json.node(pointer);
            if (id.isString()) {
                Place place = json.at(pointer);
                Place first = ids.putIfAbsent(id.asString(), place);
                if (first != null) {
                    problems.error(
                            place,
                            pointer,
                            "E101 body id " + id + " is used twice (first at " + first + ")");
                }
            }
        }
        return ids;
    }
}
