package rigibo.frontend.scene.ghost;

import rigibo.frontend.scene.Words;

import java.util.Locale;

/**
 * Two pools have become as different as two scenes.
 *
 * @param seconds after which it was seen
 * @param isChaotic whether they grew apart exponentially, not by one error or by many that add up
 */
public record Parting(double seconds, boolean isChaotic) {

    /** What it means, in a line. */
    public String in(Words words) {
        return words.of(isChaotic ? "parting.chaotic" : "parting.apart", time());
    }

    /** The same where there is little room. */
    String briefIn(Words words) {
        return words.of(isChaotic ? "parting.chaotic.brief" : "parting.apart.brief", time());
    }

    private String time() {
        return String.format(Locale.ROOT, "%.1f s", seconds);
    }
}
