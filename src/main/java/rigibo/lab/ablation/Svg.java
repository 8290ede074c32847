package rigibo.lab.ablation;

import java.util.Locale;

/** A picture in SVG, in px, y down. XChart draws SVG by a library that it does not bring along. */
final class Svg {

    /** Colours of Okabe and Ito, told apart by the colour-blind, too. */
    static final String BLUE = "#0072B2";

    static final String ORANGE = "#D55E00";
    static final String INK = "#222222";
    static final String DIM = "#666666";
    static final String GRID = "#DDDDDD";
    static final String BAND = "#E3F2EC";

    /** Where a text is held. */
    enum Anchor {
        START,
        MIDDLE,
        END
    }

    private final StringBuilder body = new StringBuilder();

    /** A text whose baseline is at y. */
    void text(double x, double y, Anchor anchor, int size, String color, String words) {
        add(
                "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" font-size=\"%d\""
                        + " fill=\"%s\">%s</text>",
                x, y, anchor.name().toLowerCase(Locale.ROOT), size, color, escaped(words));
    }

    void line(double x1, double y1, double x2, double y2, double width, String color) {
        add(
                "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\""
                        + " stroke-width=\"%.1f\"/>",
                x1, y1, x2, y2, color, width);
    }

    void dashed(double x1, double y1, double x2, double y2, String color) {
        add(
                "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\""
                        + " stroke-dasharray=\"4 4\"/>",
                x1, y1, x2, y2, color);
    }

    /** A filled box between two abscissas, whichever is first. */
    void box(double fromX, double toX, double y, double height, String color) {
        add(
                "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>",
                Math.min(fromX, toX), y, Math.abs(toX - fromX), height, color);
    }

    void dot(double x, double y, double radius, String color) {
        add("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\"/>", x, y, radius, color);
    }

    private void add(String format, Object... values) {
        body.append(String.format(Locale.ROOT, format, values)).append('\n');
    }

    private static String escaped(String words) {
        return words.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }

    /** The whole picture, on white. */
    String text(double width, double height) {
        return String.format(
                        Locale.ROOT,
                        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\""
                                + " width=\"%.0f\" height=\"%.0f\" font-family=\"sans-serif\">%n"
                                + "<rect width=\"100%%\" height=\"100%%\" fill=\"#FFFFFF\"/>%n",
                        width,
                        height,
                        width,
                        height)
                + body
                + "</svg>\n";
    }
}
