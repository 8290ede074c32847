package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Document;
import rigibo.frontend.document.Fault;

import tools.jackson.databind.JsonNode;

import java.util.List;
import java.util.Set;

/** E103: a file of format 1 uses features of format 2, which an older game could not read. */
final class FormatRules {

    private static final Set<String> SHAPES = Set.of("capsule", "compound", "chain");
    private static final Set<String> EFFECTS = Set.of("joints", "fan", "magnet");
    private static final List<String> MEMBERS =
            List.of("path", "oneWay", "click", "on", "blast", "fan", "magnet");

    private FormatRules() {}

    static void check(Document json) {
        if (json.node("/format").asInt(LevelLoader.FORMAT) >= LevelLoader.FORMAT) {
            return;
        }
        if (!json.node("/joints").isMissingNode()) {
            tell(json, "/joints", "\"joints\"");
        }
        if (!json.node(LevelSketch.STAR).isMissingNode()) {
            tell(json, LevelSketch.STAR, "\"star\"");
        }
        for (JsonNode effect : json.node("/world/effects")) {
            if (EFFECTS.contains(effect.asString(""))) {
                tell(json, "/world/effects", "the effect \"" + effect.asString() + "\"");
            }
        }
        for (int i = 0; i < json.node("/bodies").size(); i++) {
            String body = "/bodies/" + i;
            JsonNode shape = json.node(body + "/shape");
            String type = shape.path("type").asString("");
            if (SHAPES.contains(type)) {
                tell(json, body + "/shape", "the shape \"" + type + "\"");
            }
            if (shape.has("round")) {
                tell(json, body + "/shape/round", "\"round\"");
            }
            String material = json.node(body).path("material").asString("");
            if (material.equals(Substance.EMBER.title())) {
                tell(json, body + "/material", "the material \"" + material + "\"");
            }
            for (String member : MEMBERS) {
                if (json.node(body).has(member)) {
                    tell(json, body + "/" + member, "\"" + member + "\"");
                }
            }
        }
    }

    private static void tell(Document json, String pointer, String what) {
        json.error(
                pointer,
                () -> Fault.of("E103", "E103 %s needs format 2, this file states 1", what));
    }
}
