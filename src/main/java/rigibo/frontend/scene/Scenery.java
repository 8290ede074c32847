package rigibo.frontend.scene;

/** What is seen behind a scene, as far as the window goes. */
public enum Scenery {
    /** A wall of boards with tools and shelves, at dusk. */
    WORKSHOP,
    /** The Moon's plain and the Earth above it. */
    MOON
}
