package rigibo.lab.plot;

/**
 * The colours of all figures, as {@code #RRGGBB}. Colours that distinguish things are from Okabe
 * and Ito, "Color Universal Design", 2008, so colour-blind readers can distinguish them. Their
 * yellow is left out, which is hard to see on white, and their black, which is the ink.
 */
public final class Palette {

    public static final String BLUE = "#0072B2";
    public static final String VERMILLION = "#D55E00";
    public static final String GREEN = "#009E73";
    public static final String ORANGE = "#E69F00";
    public static final String SKY = "#56B4E9";
    public static final String PURPLE = "#CC79A7";
    public static final String INK = "#222222";
    public static final String DIM = "#666666";
    public static final String GRID = "#DDDDDD";
    public static final String BAND = "#E3F2EC";
    public static final String PAPER = "#FFFFFF";

    /** The share of brightness kept by a letter; orange and sky are too pale to read. */
    private static final double SHADE = 0.66;

    private Palette() {}

    /** A colour dark enough for small letters on white. */
    public static String forLetters(String color) {
        int rgb = rgb(color);
        return String.format(
                "#%02X%02X%02X", shaded(rgb >> 16), shaded(rgb >> 8 & 0xFF), shaded(rgb & 0xFF));
    }

    private static int shaded(int part) {
        return (int) Math.round(part * SHADE);
    }

    static int rgb(String color) {
        return Integer.parseInt(color.substring(1), 16);
    }
}
