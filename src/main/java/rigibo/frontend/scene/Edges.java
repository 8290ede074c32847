package rigibo.frontend.scene;

/**
 * Widths at the edges of a window that notches, round corners and the like hide, in pixels or
 * logical px.
 *
 * @param left 0 or more
 * @param top 0 or more
 * @param right 0 or more
 * @param bottom 0 or more
 */
public record Edges(double left, double top, double right, double bottom) {

    /** All of the window can be seen. */
    public static final Edges NONE = new Edges(0, 0, 0, 0);

    /** Returns them multiplied by a factor, to convert units. */
    Edges times(double factor) {
        return new Edges(factor * left, factor * top, factor * right, factor * bottom);
    }
}
