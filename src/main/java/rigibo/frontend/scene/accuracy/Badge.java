package rigibo.frontend.scene.accuracy;

import rigibo.frontend.scene.Words;

/**
 * Cost and error of the accuracy in few words; unknown values are shown as "…".
 *
 * @param words the player's
 */
public record Badge(Words words) {

    private static final String UNKNOWN = "…";

    /** Errors from this size on are told in metres, smaller ones as powers of ten. */
    private static final double PLAIN = 0.01;

    /** A smaller slowdown cannot be seen; a single late picture can cause it. */
    private static final double IN_TIME = 0.95;

    /** Says how long a step takes, ns; 0 while unknown. */
    String step(double nanos) {
        String time =
                nanos <= 0
                        ? UNKNOWN + " ms"
                        : nanos < 1e5 ? digits(nanos / 1e3) + " µs" : digits(nanos / 1e6) + " ms";
        return words.of("badge.step", time);
    }

    /** Times the time of a step at DRAFT. */
    String price(double times) {
        return (times > 0 ? digits(times) : UNKNOWN) + "× DRAFT";
    }

    String unknownPrice() {
        return price(0);
    }

    /** A distance to where EXACT has the bodies, m. */
    String error(double metres) {
        return words.of("badge.error", metres(metres));
    }

    String unknownError() {
        return words.of("badge.error", UNKNOWN);
    }

    private String metres(double metres) {
        if (metres == 0) {
            return "0 m";
        }
        return metres < PLAIN
                ? words.number("%.0e m", metres).replace("e-0", "e-")
                : digits(metres) + " m";
    }

    /** Whether the world runs so much slower than real time that it is to be told. */
    public static boolean isLate(double share) {
        return share < IN_TIME;
    }

    /** Share of real time, 1 or less. */
    public String pace(double share) {
        return words.of("badge.pace", digits(share));
    }

    /** Two digits that count, and never less than a unit's place. */
    private String digits(double value) {
        String format = value < 0.095 ? "%.3f" : value < 0.95 ? "%.2f" : "%.1f";
        return words.number(value < 9.95 ? format : "%.0f", value);
    }
}
