package rigibo.lab.plot;

import java.util.List;

/** Something to draw on; colours are those of {@link Palette}. */
public interface Picture {

    /** A text whose baseline is at y. */
    void text(double x, double y, Anchor anchor, int size, String color, String words);

    /** The same with a rim of white, to be read where lines pass beneath it. */
    void textOver(double x, double y, Anchor anchor, int size, String color, String words);

    /** A straight line. */
    void line(double x1, double y1, double x2, double y2, double width, String color);

    /** A thin line that is interrupted. */
    void dashed(double x1, double y1, double x2, double y2, String color);

    /** Lines from place to place. */
    void path(List<Spot> spots, double width, String color);

    /** A filled box between two abscissas, whichever is first. */
    void box(double fromX, double toX, double y, double height, String color);

    /** A filled disc. */
    void dot(double x, double y, double radius, String color);

    /** A filled surface and its rim. */
    void polygon(List<Spot> corners, String color, double rimWidth, String rim);
}
