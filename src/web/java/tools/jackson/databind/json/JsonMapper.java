package tools.jackson.databind.json;

import tools.jackson.databind.ObjectWriter;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** Makes and writes trees. */
public final class JsonMapper {

    private static final JsonMapper SHARED = new JsonMapper();

    private JsonMapper() {}

    public static JsonMapper shared() {
        return SHARED;
    }

    public ObjectNode createObjectNode() {
        return JsonNodeFactory.instance.objectNode();
    }

    public ObjectWriter writerWithDefaultPrettyPrinter() {
        return new ObjectWriter();
    }
}
