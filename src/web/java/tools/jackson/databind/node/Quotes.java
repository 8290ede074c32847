package tools.jackson.databind.node;

import tools.jackson.core.io.JsonStringEncoder;

/** Writes texts as in JSON. */
final class Quotes {

    private Quotes() {}

    static String of(String text) {
        StringBuilder quoted = new StringBuilder("\"");
        JsonStringEncoder.getInstance().quoteAsString(text, quoted);
        return quoted.append('"').toString();
    }
}
