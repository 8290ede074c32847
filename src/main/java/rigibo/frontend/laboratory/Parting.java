package rigibo.frontend.laboratory;

import java.util.Locale;

/**
 * Two pools have become as different as two scenes.
 *
 * @param seconds after which it was seen
 * @param isChaotic whether they grew apart exponentially, not by one error or by many that add up
 */
record Parting(double seconds, boolean isChaotic) {

    /** What it means, in a line. */
    String words() {
        String words =
                isChaotic
                        ? "chaotic: after %.1f s the two are different worlds,"
                                + " compare distributions, not paths"
                        : "after %.1f s the two are different worlds, by errors and not by chaos";
        return String.format(Locale.ROOT, words, seconds);
    }
}
