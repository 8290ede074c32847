package rigibo.frontend.scene;

/** The background behind a scene, up to the window's edges. */
public enum Scenery {
    /** A wall of boards with tools and shelves, at dusk. */
    WORKSHOP,
    /** The Moon's plain and the Earth above it. */
    MOON
}
