package rigibo.frontend.editor.pane;

/**
 * A rectangle of the window.
 *
 * @param x of its left edge, px
 * @param y of its upper edge, px
 * @param width px
 * @param height px
 */
public record Area(double x, double y, double width, double height) {

    /** Whether a point lies in it, px. */
    public boolean contains(double px, double py) {
        return px >= x && px <= x + width && py >= y && py <= y + height;
    }

    double right() {
        return x + width;
    }

    double middleX() {
        return x + width / 2;
    }

    double middleY() {
        return y + height / 2;
    }

    /** Returns this area with its upper edge so much higher, px. */
    public Area raised(double by) {
        return new Area(x, y - by, width, height + by);
    }

    /** Returns this area with its lower edge so much higher, px. */
    public Area shortened(double by) {
        return new Area(x, y, width, height - by);
    }

    /** Returns this area reduced by a margin on every side, px. */
    public Area inset(double by) {
        return new Area(x + by, y + by, width - 2 * by, height - 2 * by);
    }
}
