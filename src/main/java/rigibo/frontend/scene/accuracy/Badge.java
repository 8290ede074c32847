package rigibo.frontend.scene.accuracy;

import java.util.Locale;

/** What accuracy costs and brings, in few words; what is not known yet is "…". */
public final class Badge {

    private static final String UNKNOWN = "…";

    /** From here on an error is told in metres, below in powers of ten. */
    private static final double PLAIN = 0.01;

    private Badge() {}

    /** What a step takes, ns; 0 while unknown. */
    static String step(double nanos) {
        String time =
                nanos <= 0
                        ? UNKNOWN + " ms"
                        : nanos < 1e5 ? digits(nanos / 1e3) + " µs" : digits(nanos / 1e6) + " ms";
        return time + "/step";
    }

    /** Times the time of a step at DRAFT. */
    static String price(double times) {
        return (times > 0 ? digits(times) : UNKNOWN) + " × DRAFT";
    }

    static String unknownPrice() {
        return price(0);
    }

    /** A distance to where EXACT has the bodies, m. */
    static String error(double metres) {
        return "error " + metres(metres);
    }

    static String unknownError() {
        return "error " + UNKNOWN;
    }

    private static String metres(double metres) {
        if (metres == 0) {
            return "0 m";
        }
        return metres < PLAIN
                ? String.format(Locale.ROOT, "%.0e m", metres).replace("e-0", "e-")
                : digits(metres) + " m";
    }

    /** Share of real time, 1 or less. */
    public static String pace(double share) {
        return digits(share) + " × real time";
    }

    /** Two digits that count, and never less than a unit's place. */
    private static String digits(double value) {
        String format = value < 0.095 ? "%.3f" : value < 0.95 ? "%.2f" : "%.1f";
        return String.format(Locale.ROOT, value < 9.95 ? format : "%.0f", value);
    }
}
