package rigibo.frontend.scene.ghost;

import rigibo.frontend.scene.Words;

/** Formats lengths, from picometres to metres. */
public final class Metres {

    private static final String[] UNITS = {"m", "mm", "µm", "nm", "pm"};

    private Metres() {}

    /** A length in m with three digits in the unit that suits it. */
    public static String words(Words words, double metres) {
        double shown = metres;
        int unit = 0;
        while (shown < 0.9995 && unit < UNITS.length - 1) {
            shown *= 1000;
            unit++;
        }
        if (shown < 0.005) {
            return "0 m";
        }
        String format = shown < 9.995 ? "%.2f" : shown < 99.95 ? "%.1f" : "%.0f";
        return words.number(format, shown) + " " + UNITS[unit];
    }
}
