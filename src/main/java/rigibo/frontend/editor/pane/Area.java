package rigibo.frontend.editor.pane;

import rigibo.frontend.scene.widget.Plate;

/**
 * A rectangle of the window.
 *
 * @param x of its left edge, px
 * @param y of its upper edge, px
 * @param width px
 * @param height px
 */
public record Area(double x, double y, double width, double height) {

    /** The place of something. */
    public static Area of(Plate place) {
        return new Area(place.x(), place.y(), place.width(), place.height());
    }

    /** Whether a point lies in it, px. */
    public boolean contains(double px, double py) {
        return px >= x && px <= x + width && py >= y && py <= y + height;
    }

    /** Its right edge, px. */
    public double right() {
        return x + width;
    }

    /** Its middle from the left, px. */
    public double middleX() {
        return x + width / 2;
    }

    /** Its middle from above, px. */
    public double middleY() {
        return y + height / 2;
    }

    /** Its lower edge, px. */
    public double bottom() {
        return y + height;
    }

    /** Returns this area with its upper edge so much higher, px. */
    public Area raised(double by) {
        return new Area(x, y - by, width, height + by);
    }

    /** Returns this area with its lower edge so much higher, px. */
    public Area shortened(double by) {
        return new Area(x, y, width, height - by);
    }

    /** Returns an area as wide as this one, a gap below it, px. */
    public Area below(double gap, double high) {
        return new Area(x, bottom() + gap, width, high);
    }

    /** Returns this area with its upper edge so much lower, px. */
    public Area lowered(double by) {
        return raised(-by);
    }

    /** Returns this area with another height, px. */
    public Area resized(double high) {
        return new Area(x, y, width, high);
    }

    /** Returns this area reduced by a margin on every side, px. */
    public Area inset(double by) {
        return new Area(x + by, y + by, width - 2 * by, height - 2 * by);
    }
}
