package rigibo.frontend.demo;

import java.util.Locale;

/** Formats values with a fixed number of places. */
final class Fixed {

    private Fixed() {}

    /** A value by a format; what rounds to zero has no sign, which would flicker with round-off. */
    static String words(String format, double value) {
        String words = String.format(Locale.ROOT, format, value);
        String zero = String.format(Locale.ROOT, format, 0.0);
        return words.equals("-" + zero) ? zero : words;
    }
}
