package rigibo.frontend.scene;

/**
 * What the edges of a window lose to notches, round corners and the like, in pixels or logical px.
 *
 * @param left 0 or more
 * @param top 0 or more
 * @param right 0 or more
 * @param bottom 0 or more
 */
public record Edges(double left, double top, double right, double bottom) {

    /** All of the window can be seen. */
    public static final Edges NONE = new Edges(0, 0, 0, 0);

    /** Returns them in units of which there are so many in one of these. */
    Edges times(double factor) {
        return new Edges(factor * left, factor * top, factor * right, factor * bottom);
    }
}
