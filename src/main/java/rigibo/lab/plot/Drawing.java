package rigibo.lab.plot;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/** A recorded drawing, kept until its height is known, and then drawn on any number of pictures. */
public final class Drawing implements Picture {

    private final List<Consumer<Picture>> strokes = new ArrayList<>();
    private final double width;
    private double height;

    /** A drawing of a width in px. */
    public Drawing(double width) {
        this.width = width;
    }

    public double width() {
        return width;
    }

    public double height() {
        return height;
    }

    /** Sets its height, px. */
    public void endAt(double bottom) {
        height = bottom;
    }

    /** Draws all of it on a picture. */
    public void on(Picture picture) {
        strokes.forEach(stroke -> stroke.accept(picture));
    }

    /** The drawing in SVG. */
    public String svg() {
        Svg svg = new Svg();
        on(svg);
        return svg.text(width, height);
    }

    @Override
    public void text(double x, double y, Anchor anchor, int size, String color, String words) {
        strokes.add(picture -> picture.text(x, y, anchor, size, color, words));
    }

    @Override
    public void textOver(double x, double y, Anchor anchor, int size, String color, String words) {
        strokes.add(picture -> picture.textOver(x, y, anchor, size, color, words));
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, String color) {
        strokes.add(picture -> picture.line(x1, y1, x2, y2, width, color));
    }

    @Override
    public void dashed(double x1, double y1, double x2, double y2, String color) {
        strokes.add(picture -> picture.dashed(x1, y1, x2, y2, color));
    }

    @Override
    public void path(List<Spot> spots, double width, String color) {
        strokes.add(picture -> picture.path(spots, width, color));
    }

    @Override
    public void box(double fromX, double toX, double y, double height, String color) {
        strokes.add(picture -> picture.box(fromX, toX, y, height, color));
    }

    @Override
    public void dot(double x, double y, double radius, String color) {
        strokes.add(picture -> picture.dot(x, y, radius, color));
    }

    @Override
    public void polygon(List<Spot> corners, String color, double rimWidth, String rim) {
        strokes.add(picture -> picture.polygon(corners, color, rimWidth, rim));
    }
}
