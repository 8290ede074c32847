package rigibo.frontend.scene;

import rigibo.backend.geometry.Shape;

/**
 * The surface on which scenes draw. Bodies and particles lie below everything else; shapes and text
 * follow in their order. Screen coordinates are logical pixels, y down; sizes are px.
 */
public interface Canvas {

    /** Position of a text relative to its point. */
    enum Align {
        LEFT,
        CENTRE,
        RIGHT
    }

    /** A round face for words, a monospaced one for numbers. */
    enum Font {
        WORDS,
        NUMBERS
    }

    /** A special way to draw a body; {@link #PLAIN} for none. */
    enum Mood {
        PLAIN,
        /** Lifted under the pointer; a RigiBo winces. */
        HOVERED,
        /** Asleep: dimmed a little. */
        ASLEEP,
        /** Only an outline: the same body elsewhere or at another time. */
        GHOST,
        /** Falls, or the level is lost: a RigiBo is afraid. */
        WORRIED,
        /** The level is solved: a RigiBo laughs. */
        CHEERING
    }

    /** The layout of the window. */
    Layout layout();

    /**
     * A scenery as a window of a rectangle's shape shows it, below all that is drawn in there: to
     * be drawn first.
     */
    void scenery(Scenery behind, double x, double y, double width, double height);

    /** Draws the world through a camera from now on. */
    void camera(Camera camera);

    /** Where RigiBo faces look, world m. */
    void gaze(double worldX, double worldY);

    /** A body at a pose in the world: m, rad. */
    void body(Shape shape, double x, double y, double angle, Skin skin, Mood mood);

    /** A small square particle in the world: position in m, size in m, angle in rad. */
    void particle(double x, double y, double size, double angle, Color color);

    /** A soft, round particle in the world, such as dust: position in m, width in m. */
    void puff(double x, double y, double size, Color color);

    /** Adds light about a point of the world to the picture: position in m, width in m. */
    void glow(double x, double y, double size, Color color);

    /** Greys out the world in this frame, 0 not at all to 1. */
    void veil(double share);

    /** A straight line on the screen. */
    void line(double x1, double y1, double x2, double y2, double width, Color color);

    /** A straight line between two points of the world, m, as a camera sees it. */
    default void line(
            Camera camera, double x1, double y1, double x2, double y2, double width, Color color) {
        line(
                camera.screenX(x1),
                camera.screenY(y1),
                camera.screenX(x2),
                camera.screenY(y2),
                width,
                color);
    }

    /** A line through a number of points x₀, y₀, x₁, y₁, … of the screen, round at its corners. */
    void curve(double[] xy, int points, double width, Color color);

    /** A filled disc on the screen. */
    void disc(double x, double y, double radius, Color color);

    /** Part of a ring, clockwise from the top, 0 to 1. */
    void ring(double x, double y, double radius, double width, double fraction, Color color);

    /** A filled rectangle with round corners. */
    void panel(double x, double y, double width, double height, double corner, Color color);

    /** Fills the whole window. */
    default void cover(Color color) {
        Layout all = layout();
        panel(all.left(), all.top(), all.width(), all.height(), 0, color);
    }

    /** The edge of a rectangle with round corners. */
    void frame(double x, double y, double width, double height, double corner, Color color);

    /**
     * Text with its middle height at y; sizes of 16 px or more. In a small window small text is
     * drawn larger than that, see {@link Layout#textSize}.
     */
    void text(String words, double x, double y, double size, Font font, Align align, Color color);

    /** Width of a text as it would be drawn, px. */
    double textWidth(String words, double size, Font font);

    /** A curve through values from 0 (bottom) to 1 (top), evenly spaced over a rectangle. */
    void graph(double[] values, int count, double x, double y, double w, double h, Color color);
}
