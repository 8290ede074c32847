package rigibo.frontend.scene.ghost;

import java.util.Locale;

/**
 * Two pools have become as different as two scenes.
 *
 * @param seconds after which it was seen
 * @param isChaotic whether they grew apart exponentially, not by one error or by many that add up
 */
public record Parting(double seconds, boolean isChaotic) {

    /** What it means, in a line. */
    public String words() {
        String words =
                isChaotic
                        ? "chaotic: after %.1f s the two are different worlds,"
                                + " compare distributions, not paths"
                        : "after %.1f s the two are different worlds, by errors and not by chaos";
        return String.format(Locale.ROOT, words, seconds);
    }

    /** The same where there is little room. */
    String brief() {
        String words =
                isChaotic
                        ? "chaos: another world after %.1f s"
                        : "apart after %.1f s, not by chaos";
        return String.format(Locale.ROOT, words, seconds);
    }
}
