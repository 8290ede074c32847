package rigibo.frontend.scene;

/**
 * What a window that is held in a hand asks of a layout, logical px.
 *
 * @param least smallest side of whatever is touched; 0 in windows on a desk
 * @param hidden what is not seen of the window's edges
 */
public record Touch(double least, Edges hidden) {

    /** A window on a desk: nothing is asked. */
    public static final Touch NONE = new Touch(0, Edges.NONE);
}
