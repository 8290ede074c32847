package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Document;

import tools.jackson.databind.JsonNode;

/** E103 a file of format 1 that holds what came with format 2: an older game would not read it. */
final class FormatRules {

    private FormatRules() {}

    static void check(Document json) {
        if (json.node("/format").asInt(LevelLoader.FORMAT) >= LevelLoader.FORMAT) {
            return;
        }
        for (int i = 0; i < json.node("/bodies").size(); i++) {
            String body = "/bodies/" + i;
            JsonNode shape = json.node(body + "/shape");
            String type = shape.path("type").asString("");
            if (type.equals("capsule") || type.equals("compound")) {
                tell(json, body + "/shape", "the shape \"" + type + "\"");
            }
            if (shape.has("round")) {
                tell(json, body + "/shape/round", "\"round\"");
            }
            if (json.node(body).has("path")) {
                tell(json, body + "/path", "\"path\"");
            }
        }
    }

    private static void tell(Document json, String pointer, String what) {
        json.error(pointer, () -> "E103 " + what + " needs format 2, this file states 1");
    }
}
