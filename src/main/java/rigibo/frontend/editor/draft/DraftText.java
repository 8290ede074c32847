package rigibo.frontend.editor.draft;

import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.JsonNodeFactory;

import java.util.ArrayList;
import java.util.List;

/**
 * A document as the game's own levels are written: what fits on a line stands on one, the rest a
 * member a line. The library's printer knows only one of the two for all.
 */
public final class DraftText {

    private static final int WIDTH = 100;
    private static final String INDENT = "  ";

    private DraftText() {}

    /** The text of a level file. */
    public static String of(JsonNode document) {
        return broken(document, "") + "\n";
    }

    private static String text(JsonNode node, String indent, int used) {
        String line = line(node);
        boolean fits = indent.length() + used + line.length() <= WIDTH;
        return fits || node.isEmpty() ? line : broken(node, indent);
    }

    private static String broken(JsonNode node, String indent) {
        String inner = indent + INDENT;
        List<String> rows = new ArrayList<>();
        if (node.isObject()) {
            for (var member : node.properties()) {
                String name = quoted(member.getKey()) + ": ";
                rows.add(inner + name + text(member.getValue(), inner, name.length() + 1));
            }
        } else {
            node.forEach(element -> rows.add(inner + text(element, inner, 1)));
        }
        String open = node.isObject() ? "{" : "[";
        String close = node.isObject() ? "}" : "]";
        return open + "\n" + String.join(",\n", rows) + "\n" + indent + close;
    }

    private static String line(JsonNode node) {
        List<String> parts = new ArrayList<>();
        if (node.isObject()) {
            for (var member : node.properties()) {
                parts.add(quoted(member.getKey()) + ": " + line(member.getValue()));
            }
            return "{" + String.join(", ", parts) + "}";
        }
        if (node.isArray()) {
            node.forEach(element -> parts.add(line(element)));
            return "[" + String.join(", ", parts) + "]";
        }
        return node.toString();
    }

    private static String quoted(String words) {
        return JsonNodeFactory.instance.stringNode(words).toString();
    }
}
