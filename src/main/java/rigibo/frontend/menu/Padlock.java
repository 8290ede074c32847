package rigibo.frontend.menu;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/** A padlock on a level or world that is not open yet. */
final class Padlock {

    private Padlock() {}

    /**
     * Draws one about a point.
     *
     * @param scale 1 is 32 px wide
     */
    static void draw(Canvas canvas, double x, double y, double scale) {
        canvas.ring(x, y - 8 * scale, 10 * scale, 4 * scale, 1, Color.TEXT_DIM);
        canvas.panel(
                x - 16 * scale, y - 8 * scale, 32 * scale, 26 * scale, 5 * scale, Color.TEXT_DIM);
        canvas.disc(x, y + 3 * scale, 4 * scale, Color.DUSK_TOP);
        canvas.line(x, y + 3 * scale, x, y + 11 * scale, 3 * scale, Color.DUSK_TOP);
    }
}
