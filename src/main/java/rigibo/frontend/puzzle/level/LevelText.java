package rigibo.frontend.puzzle.level;

import tools.jackson.core.io.JsonStringEncoder;
import tools.jackson.databind.JsonNode;

/**
 * Writes a document in the layout of the game's own levels: a value that fits on one line is
 * written on one, others take a line per member. The library's printer can only use one layout for
 * all values.
 */
public final class LevelText {

    private static final int WIDTH = 100;
    private static final String INDENT = "  ";
    private static final JsonStringEncoder ENCODER = JsonStringEncoder.getInstance();

    private final StringBuilder text = new StringBuilder();

    private LevelText() {}

    /** The text of a level file. */
    public static String of(JsonNode document) {
        LevelText level = new LevelText();
        level.rows(document, "");
        return level.text.append('\n').toString();
    }

    /** Writes a value on one line if it fits, and otherwise on several. */
    private void value(JsonNode node, String indent, int used) {
        int begin = text.length();
        boolean fits = line(node, begin + WIDTH - indent.length() - used);
        if (!fits && !node.isEmpty()) {
            text.setLength(begin);
            rows(node, indent);
        }
    }

    private void rows(JsonNode node, String indent) {
        String inner = indent + INDENT;
        String between = "\n";
        text.append(node.isObject() ? '{' : '[');
        for (var member : node.properties()) {
            text.append(between).append(inner);
            int begin = text.length();
            name(member.getKey());
            value(member.getValue(), inner, text.length() - begin + 1);
            between = ",\n";
        }
        for (int i = 0; node.isArray() && i < node.size(); i++) {
            text.append(between).append(inner);
            value(node.get(i), inner, 1);
            between = ",\n";
        }
        text.append('\n').append(indent).append(node.isObject() ? '}' : ']');
    }

    /** Writes a value on one line, or its beginning; returns whether it ends before {@code end}. */
    private boolean line(JsonNode node, int end) {
        if (node.isObject()) {
            return members(node, end);
        }
        if (node.isArray()) {
            return elements(node, end);
        }
        if (node.isString()) {
            quote(node.asString());
        } else {
            text.append(node.asString("null"));
        }
        return text.length() <= end;
    }

    private boolean members(JsonNode object, int end) {
        String between = "{";
        for (var member : object.properties()) {
            text.append(between);
            name(member.getKey());
            if (!line(member.getValue(), end)) {
                return false;
            }
            between = ", ";
        }
        text.append(object.isEmpty() ? "{}" : "}");
        return text.length() <= end;
    }

    private boolean elements(JsonNode array, int end) {
        String between = "[";
        for (JsonNode element : array) {
            text.append(between);
            if (!line(element, end)) {
                return false;
            }
            between = ", ";
        }
        text.append(array.isEmpty() ? "[]" : "]");
        return text.length() <= end;
    }

    private void name(String name) {
        quote(name);
        text.append(": ");
    }

    /**
     * Writes a text in quotes. Printing a node instead would make a printer of a kilobyte for every
     * word.
     */
    private void quote(String words) {
        text.append('"');
        ENCODER.quoteAsString(words, text);
        text.append('"');
    }
}
