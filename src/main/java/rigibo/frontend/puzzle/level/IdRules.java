package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Document;
import rigibo.frontend.document.Fault;
import rigibo.frontend.document.Place;
import rigibo.frontend.document.Suggestion;

import tools.jackson.databind.JsonNode;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/** E101 an id used twice; E102 a reference to an unknown one. */
final class IdRules {

    private final Document json;

    /**
     * The pointer at which each id is stated first. Bodies and joints with other errors are
     * included; otherwise each reference to them would be one more error.
     */
    private final Map<String, String> ids = new HashMap<>();

    private IdRules(Document json) {
        this.json = json;
    }

    static void check(LevelSketch sketch) {
        IdRules rules = new IdRules(sketch.json());
        rules.collect("/bodies", "body");
        rules.collect("/joints", "joint");
        for (Located<Solution> solution : sketch.ways()) {
            for (int i = 0; i < solution.part().clicks().size(); i++) {
                rules.reference(solution.pointer() + "/clicks/" + i);
            }
        }
        JsonNode star = sketch.json().node(LevelSketch.STAR);
        if (star.has("body") || star.has("joint")) {
            rules.reference(LevelSketch.STAR);
        }
    }

    private void collect(String list, String kind) {
        for (int i = 0; i < json.node(list).size(); i++) {
            String pointer = list + "/" + i + "/id";
            JsonNode id = json.node(pointer);
            if (id.isString()) {
                String first = ids.putIfAbsent(id.asString(), pointer);
                if (first != null) {
                    json.error(pointer, () -> twice(kind, id, json.at(first)));
                }
            }
        }
    }

    private static Fault twice(String kind, JsonNode id, Place first) {
        String words = "E101 %s id %s is used twice (first at %s)";
        return Fault.of("E101", words, kind, id, first).naming(id.asString());
    }

    /**
     * Checks the reference of a click or a star.
     *
     * @param at its pointer
     */
    private void reference(String at) {
        String kind = json.node(at).has("joint") ? "joint" : "body";
        String list = kind.equals("joint") ? "/joints/" : "/bodies/";
        String id = json.node(at + "/" + kind).asString("");
        if (!ids.getOrDefault(id, "").startsWith(list)) {
            json.error(at + "/" + kind, () -> unknown(kind, list, id));
        }
    }

    private Fault unknown(String kind, String list, String id) {
        Set<String> known =
                ids.entrySet().stream()
                        .filter(entry -> entry.getValue().startsWith(list))
                        .map(Map.Entry::getKey)
                        .collect(Collectors.toSet());
        String words = "E102 no %s has the id \"%s\"%s";
        return Fault.of("E102", words, kind, id, Suggestion.among(known, id)).naming(id);
    }
}
