package rigibo.frontend.document;

import tools.jackson.databind.JsonNode;

import java.util.Locale;

/** Makes any text of a file safe to show in one line of a terminal or a window. */
final class Escape {

    /** Most characters of a value in a message; more would bury the message. */
    private static final int SHOWN = 60;

    private Escape() {}

    /**
     * Replaces line breaks and everything else that does not print by escapes such as {@code \n} or
     * {@code \u001b}.
     */
    static String controls(String words) {
        if (words.codePoints().allMatch(Escape::prints)) {
            return words;
        }
        StringBuilder shown = new StringBuilder();
        words.codePoints().forEach(letter -> append(shown, letter));
        return shown.toString();
    }

    /** Shortens a text that is too long to be shown. */
    static String shortened(String words) {
        return words.length() <= SHOWN
                ? words
                : words.substring(0, words.offsetByCodePoints(0, SHOWN / 2)) + "…";
    }

    static String quoted(String words) {
        return "\"" + shortened(words) + "\"";
    }

    /** A value as the file states it, shortened if it is long. */
    static String shown(JsonNode node) {
        return switch (node.getNodeType()) {
            case OBJECT -> "an object";
            case ARRAY -> "a list";
            case STRING -> quoted(node.stringValue());
            case NUMBER, BOOLEAN, NULL, BINARY, MISSING, POJO -> node.toString();
        };
    }

    /**
     * Also excludes characters that change the direction of writing, and halves of surrogate pairs.
     */
    private static boolean prints(int letter) {
        return switch (Character.getType(letter)) {
            case Character.CONTROL,
                    Character.FORMAT,
                    Character.SURROGATE,
                    Character.LINE_SEPARATOR,
                    Character.PARAGRAPH_SEPARATOR ->
                    false;
            default -> true;
        };
    }

    private static void append(StringBuilder shown, int letter) {
        if (prints(letter)) {
            shown.appendCodePoint(letter);
            return;
        }
        switch (letter) {
            case '\n' -> shown.append("\\n");
            case '\r' -> shown.append("\\r");
            case '\t' -> shown.append("\\t");
            default -> shown.append(String.format(Locale.ROOT, "\\u%04x", letter));
        }
    }
}
