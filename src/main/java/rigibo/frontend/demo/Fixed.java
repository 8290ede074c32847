package rigibo.frontend.demo;

import rigibo.frontend.scene.Words;

/** Formats values with a fixed number of places. */
final class Fixed {

    private Fixed() {}

    /** A value by a format; what rounds to zero has no sign, which would flicker with round-off. */
    static String words(Words language, String format, double value) {
        String words = language.number(format, value);
        String zero = language.number(format, 0.0);
        return words.equals("-" + zero) ? zero : words;
    }
}
