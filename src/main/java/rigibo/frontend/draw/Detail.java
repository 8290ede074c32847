package rigibo.frontend.draw;

/** How much detail is drawn. */
public enum Detail {
    /** Everything. */
    FULL,
    /** No shadows, no grain, no background but its colours: for OpenGL without a graphics card. */
    LITE
}
