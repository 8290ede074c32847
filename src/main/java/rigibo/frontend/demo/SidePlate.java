package rigibo.frontend.demo;

import rigibo.backend.Pool;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.accuracy.EnergyPlate;

/** The plate at the right with two sides: where the time of a frame goes, and the energy. */
final class SidePlate {

    static final double WIDTH = StageProfile.WIDTH;

    private static final double TAB_HEIGHT = 24;

    /** The sides by the words on their tabs, and where these begin and how wide they are, px. */
    private enum Side {
        FRAME("frame", 8, 58),
        ENERGY("energy", 68, 68);

        private final String words;
        private final double left;
        private final double width;

        Side(String words, double left, double width) {
            this.words = words;
            this.left = left;
            this.width = width;
        }
    }

    private final Pool pool;
    private final double x;
    private final double y;
    private final StageProfile profile = new StageProfile();
    private final EnergyPlate energy;
    private Side shown = Side.FRAME;

    /** A plate with its upper left corner at (x, y), px, its first side up. */
    SidePlate(Pool pool, double x, double y) {
        this.pool = pool;
        this.x = x;
        this.y = y;
        energy = new EnergyPlate(pool);
    }

    /** The same for another pool: a scene that restarts shows the side that it has shown. */
    SidePlate of(Pool other) {
        SidePlate next = new SidePlate(other, x, y);
        next.shown = shown;
        return next;
    }

    void beforeStep() {
        energy.beforeStep();
    }

    void afterStep() {
        energy.afterStep();
        profile.step(pool.report());
    }

    /** Takes the time that drawing took, ns. */
    void drawn(long nanos) {
        profile.drawing(nanos);
    }

    void draw(Canvas canvas) {
        switch (shown) {
            case FRAME -> profile.draw(canvas, x, y);
            case ENERGY -> energy.draw(canvas, x, y, WIDTH);
        }
        for (Side side : Side.values()) {
            draw(canvas, side);
        }
    }

    private void draw(Canvas canvas, Side side) {
        boolean isLit = side == shown;
        Color plate = isLit ? Color.BRASS : Color.PANEL_LIT;
        canvas.panel(x + side.left, y + 6, side.width, TAB_HEIGHT, 8, plate);
        canvas.text(
                side.words,
                x + side.left + side.width / 2,
                y + 6 + TAB_HEIGHT / 2,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                isLit ? Color.DUSK_TOP : Color.TEXT_DIM);
    }

    /** Shows the other side. */
    void turnOver() {
        shown = shown == Side.FRAME ? Side.ENERGY : Side.FRAME;
    }

    /** The pointer went down; returns whether on a tab. */
    boolean pointerPressed(double px, double py) {
        for (Side side : Side.values()) {
            boolean isBeside = px < x + side.left || px > x + side.left + side.width;
            if (!isBeside && py >= y + 6 && py <= y + 6 + TAB_HEIGHT) {
                shown = side;
                return true;
            }
        }
        return false;
    }
}
