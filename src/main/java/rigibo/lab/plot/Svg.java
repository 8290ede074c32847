package rigibo.lab.plot;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;

/** A picture in SVG. XChart is not used, since it needs another library for SVG. */
public final class Svg implements Picture {

    private static final String LETTERS =
            "system-ui, 'Segoe UI', Roboto, Helvetica, Arial, 'DejaVu Sans', sans-serif";

    private final StringBuilder body = new StringBuilder();

    @Override
    public void text(double x, double y, Anchor anchor, int size, String color, String words) {
        letters(x, y, anchor, size, color, "", words);
    }

    @Override
    public void textOver(double x, double y, Anchor anchor, int size, String color, String words) {
        String rim =
                " stroke=\"#FFFFFF\" stroke-width=\"4\" stroke-linejoin=\"round\""
                        + " paint-order=\"stroke\"";
        letters(x, y, anchor, size, color, rim, words);
    }

    private void letters(
            double x, double y, Anchor anchor, int size, String color, String rim, String words) {
        add(
                "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\" font-size=\"%d\""
                        + " fill=\"%s\"%s>%s</text>",
                x, y, anchor.name().toLowerCase(Locale.ROOT), size, color, rim, escaped(words));
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, String color) {
        add(
                "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\""
                        + " stroke-width=\"%.1f\"/>",
                x1, y1, x2, y2, color, width);
    }

    @Override
    public void dashed(double x1, double y1, double x2, double y2, String color) {
        add(
                "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"%s\""
                        + " stroke-dasharray=\"4 4\"/>",
                x1, y1, x2, y2, color);
    }

    @Override
    public void path(List<Spot> spots, double width, String color) {
        add(
                "<polyline points=\"%s\" fill=\"none\" stroke=\"%s\" stroke-width=\"%.1f\""
                        + " stroke-linejoin=\"round\"/>",
                list(spots), color, width);
    }

    @Override
    public void box(double fromX, double toX, double y, double height, String color) {
        add(
                "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"%s\"/>",
                Math.min(fromX, toX), y, Math.abs(toX - fromX), height, color);
    }

    @Override
    public void dot(double x, double y, double radius, String color) {
        add("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\" fill=\"%s\"/>", x, y, radius, color);
    }

    @Override
    public void polygon(List<Spot> corners, String color, double rimWidth, String rim) {
        add(
                "<polygon points=\"%s\" fill=\"%s\" stroke=\"%s\" stroke-width=\"%.1f\"/>",
                list(corners), color, rim, rimWidth);
    }

    private static String list(List<Spot> spots) {
        return spots.stream()
                .map(spot -> String.format(Locale.ROOT, "%.1f,%.1f", spot.x(), spot.y()))
                .collect(Collectors.joining(" "));
    }

    private void add(String format, Object... values) {
        body.append(String.format(Locale.ROOT, format, values)).append('\n');
    }

    private static String escaped(String words) {
        return words.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;");
    }

    /** The whole picture, on white. */
    public String text(double width, double height) {
        return String.format(
                        Locale.ROOT,
                        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\""
                                + " width=\"%.0f\" height=\"%.0f\" font-family=\"%s\">%n"
                                + "<rect width=\"100%%\" height=\"100%%\" fill=\"#FFFFFF\"/>%n",
                        width,
                        height,
                        width,
                        height,
                        LETTERS)
                + body
                + "</svg>\n";
    }
}
