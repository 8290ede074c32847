package rigibo.lab.plot;

import java.util.List;

/** A surface to draw on; the colours are those of {@link Palette}. */
public interface Picture {

    /** A text whose baseline is at y. */
    void text(double x, double y, Anchor anchor, int size, String color, String words);

    /** Draws a text with a white rim, readable on top of lines. */
    void textOver(double x, double y, Anchor anchor, int size, String color, String words);

    /** A straight line. */
    void line(double x1, double y1, double x2, double y2, double width, String color);

    /** Draws a thin dashed line. */
    void dashed(double x1, double y1, double x2, double y2, String color);

    /** Draws lines from spot to spot. */
    void path(List<Spot> spots, double width, String color);

    /** Draws a filled box between two x, in any order. */
    void box(double fromX, double toX, double y, double height, String color);

    /** A filled disc. */
    void dot(double x, double y, double radius, String color);

    /** Draws a filled polygon and its rim. */
    void polygon(List<Spot> corners, String color, double rimWidth, String rim);
}
