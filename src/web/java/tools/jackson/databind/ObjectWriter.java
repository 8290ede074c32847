package tools.jackson.databind;

import tools.jackson.databind.node.JsonNodeFactory;

import java.nio.charset.StandardCharsets;
import java.util.Map;

/** Writes trees in the library's layout: a line for each value of an object, lists in one line. */
public final class ObjectWriter {

    private static final String INDENT = "  ";

    public byte[] writeValueAsBytes(Object tree) {
        return writeValueAsString(tree).getBytes(StandardCharsets.UTF_8);
    }

    public String writeValueAsString(Object tree) {
        StringBuilder text = new StringBuilder();
        write((JsonNode) tree, "\n", text);
        return text.toString();
    }

    private static void write(JsonNode node, String line, StringBuilder text) {
        if (node.isObject() && !node.isEmpty()) {
            String inside = line + INDENT;
            String between = "{";
            for (Map.Entry<String, JsonNode> entry : node.properties()) {
                String name = JsonNodeFactory.instance.stringNode(entry.getKey()).toString();
                text.append(between).append(inside).append(name).append(" : ");
                write(entry.getValue(), inside, text);
                between = ",";
            }
            text.append(line).append('}');
        } else if (node.isArray() && !node.isEmpty()) {
            String between = "[ ";
            for (JsonNode value : node) {
                text.append(between);
                write(value, line, text);
                between = ", ";
            }
            text.append(" ]");
        } else {
            text.append(node.isObject() ? "{ }" : node.isArray() ? "[ ]" : node.toString());
        }
    }
}
