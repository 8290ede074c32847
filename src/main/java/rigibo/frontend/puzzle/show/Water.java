package rigibo.frontend.puzzle.show;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;

/**
 * The water of a level, above the bodies, so that they look submerged. It fills the whole width of
 * the window: at the sides of a level it would otherwise end in an upright edge without a wall.
 */
final class Water {

    /** Opacity of water, and of its surface. */
    private static final double DEPTH = 0.22;

    private static final double SURFACE = 0.7;

    /** Deep water is a little darker: number of layers, their opacity, and their height, px. */
    private static final int LAYERS = 5;

    private static final double DARKER = 0.05;
    private static final double LAYER = 70;

    private Water() {}

    /**
     * Draws it.
     *
     * @param y of its surface, px
     */
    static void draw(Canvas canvas, double y) {
        Layout window = canvas.layout();
        fill(canvas, y, Color.ICE.alpha(DEPTH));
        for (int i = 1; i <= LAYERS; i++) {
            fill(canvas, y + i * LAYER, Color.DUSK_TOP.alpha(DARKER));
        }
        canvas.line(window.left(), y, window.right(), y, 2, Color.ICE.alpha(SURFACE));
    }

    private static void fill(Canvas canvas, double y, Color color) {
        Layout window = canvas.layout();
        double high = window.bottom() - y;
        if (high > 0) {
            canvas.panel(window.left(), y, window.width(), high, 0, color);
        }
    }
}
