package rigibo.frontend.draw;

/** How much detail is drawn. */
public enum Detail {
    /** Everything. */
    FULL,
    /** Without shadows, grain and the background's details: for OpenGL without a graphics card. */
    LITE
}
