package rigibo.frontend.scene.accuracy;

import rigibo.frontend.scene.Words;

/** Formats an energy, short enough for a column. */
final class Joules {

    private static final double KILO = 1e3;
    private static final double MEGA = 1e6;

    /** Below this there are two places and no digit that counts. */
    private static final double LEAST_PLAIN = 0.1;

    private Joules() {}

    static String words(Words words, double joules) {
        double size = Math.abs(joules);
        if (size == 0) {
            return "0 J";
        }
        if (size < LEAST_PLAIN) {
            return words.number("%.0e J", joules).replace("e-0", "e-");
        }
        if (size < KILO) {
            return words.number(size < 100 ? "%.2f J" : "%.1f J", joules);
        }
        return size < MEGA
                ? words.number("%.1f kJ", joules / KILO)
                : words.number("%.0f kJ", joules / KILO);
    }
}
