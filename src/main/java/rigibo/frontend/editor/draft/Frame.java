package rigibo.frontend.editor.draft;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

import java.util.List;

/** The least that a document must contain for the editor to show it. */
final class Frame {

    private static final int FORMAT = 2;
    private static final List<String> OBJECTS =
            List.of("title", "hint", "world", "rules", "ball", "platform");
    private static final List<String> LISTS = List.of("bodies", "solutions", "moreBalls", "joints");

    private Frame() {}

    static ObjectNode of(JsonNode document) {
        if (!(document instanceof ObjectNode level)) {
            throw new IllegalArgumentException("it is no level");
        }
        if (isNewer(level)) {
            throw new IllegalArgumentException("it was made for a newer RigiBo");
        }
        for (String name : OBJECTS) {
            require(level, name, level.path(name).isObject());
        }
        for (String name : LISTS) {
            require(level, name, level.path(name).isArray());
        }
        return completed(level);
    }

    static boolean isNewer(JsonNode document) {
        return document.path("format").asInt(FORMAT) > FORMAT;
    }

    private static void require(ObjectNode level, String name, boolean isSound) {
        if (level.has(name) && !isSound) {
            throw new IllegalArgumentException("its \"" + name + "\" is something else");
        }
    }

    private static ObjectNode completed(ObjectNode level) {
        ObjectNode whole = JsonNodeFactory.instance.objectNode();
        whole.setAll(level);
        for (var member : NewLevel.document().properties()) {
            whole.putIfAbsent(member.getKey(), member.getValue());
        }
        return whole;
    }
}
