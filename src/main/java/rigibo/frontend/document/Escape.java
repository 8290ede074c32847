package rigibo.frontend.document;

import tools.jackson.databind.JsonNode;

import java.util.Locale;

/** Makes any text of a file safe to show in one line of a terminal or a window. */
final class Escape {

    /** Characters of a value that a message shows; more would bury the message. */
    private static final int SHOWN = 60;

    private Escape() {}

    /**
     * The words with line breaks and all else that does not print as {@code \n} or {@code \u001b}.
     */
    static String controls(String words) {
        if (words.codePoints().allMatch(Escape::prints)) {
            return words;
        }
        StringBuilder shown = new StringBuilder();
        words.codePoints().forEach(letter -> append(shown, letter));
        return shown.toString();
    }

    /** The beginning of what is too long to be shown. */
    static String shortened(String words) {
        return words.length() <= SHOWN
                ? words
                : words.substring(0, words.offsetByCodePoints(0, SHOWN / 2)) + "…";
    }

    static String quoted(String words) {
        return "\"" + shortened(words) + "\"";
    }

    /** A value as a file states it, as far as it is short. */
    static String shown(JsonNode node) {
        return switch (node.getNodeType()) {
            case OBJECT -> "an object";
            case ARRAY -> "a list";
            case STRING -> quoted(node.stringValue());
            case NUMBER, BOOLEAN, NULL, BINARY, MISSING, POJO -> node.toString();
        };
    }

    /** Also not what turns the direction of writing, or half of a character. */
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
