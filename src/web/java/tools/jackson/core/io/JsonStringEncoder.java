package tools.jackson.core.io;

/** Writes texts as in JSON, within quotes. */
public final class JsonStringEncoder {

    private static final JsonStringEncoder INSTANCE = new JsonStringEncoder();

    private JsonStringEncoder() {}

    public static JsonStringEncoder getInstance() {
        return INSTANCE;
    }

    /** Adds a text without its quotes. */
    public void quoteAsString(CharSequence text, StringBuilder to) {
        for (int i = 0; i < text.length(); i++) {
            char letter = text.charAt(i);
            switch (letter) {
                case '"', '\\' -> to.append('\\').append(letter);
                case '\n' -> to.append("\\n");
                case '\r' -> to.append("\\r");
                case '\t' -> to.append("\\t");
                default -> append(letter, to);
            }
        }
    }

    private static void append(char letter, StringBuilder to) {
        if (letter < ' ') {
            to.append("\\u00").append(letter < 16 ? "0" : "").append(Integer.toHexString(letter));
        } else {
            to.append(letter);
        }
    }
}
