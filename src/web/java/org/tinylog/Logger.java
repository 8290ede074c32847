package org.tinylog;

/** Writes warnings to the console. */
public final class Logger {

    private Logger() {}

    public static void warn(Object message) {
        System.err.println(message);
    }

    /** Writes a text with its {} replaced. */
    public static void warn(String message, Object... values) {
        String text = message;
        for (Object value : values) {
            int at = text.indexOf("{}");
            text = text.substring(0, at) + value + text.substring(at + 2);
        }
        warn((Object) text);
    }
}
