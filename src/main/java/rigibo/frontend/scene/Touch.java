package rigibo.frontend.scene;

/**
 * What a layout must leave for fingers in a handheld window, logical px.
 *
 * @param least smallest side of anything to touch; 0 in desktop windows
 * @param hidden the hidden parts of the window's edges
 */
public record Touch(double least, Edges hidden) {

    /** A desktop window, which needs nothing. */
    public static final Touch NONE = new Touch(0, Edges.NONE);
}
