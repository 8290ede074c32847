package rigibo.frontend.scene.ghost;

import rigibo.frontend.scene.Words;

/**
 * The moment at which two pools have become as different as two unrelated scenes.
 *
 * @param seconds time at which it was detected, s
 * @param isChaotic whether they diverged exponentially, not by one error or by many that add up
 */
public record Parting(double seconds, boolean isChaotic) {

    /** Describes it in a line. */
    public String in(Words words) {
        return words.of(isChaotic ? "parting.chaotic" : "parting.apart", time(words));
    }

    /** Describes it in few words. */
    String briefIn(Words words) {
        return words.of(isChaotic ? "parting.chaotic.brief" : "parting.apart.brief", time(words));
    }

    private String time(Words words) {
        return words.number("%.1f s", seconds);
    }
}
