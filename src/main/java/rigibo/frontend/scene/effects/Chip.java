package rigibo.frontend.scene.effects;

import rigibo.backend.effect.Effect;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;

/**
 * The chip of an effect in the bar.
 *
 * @param reason the effect and what it does
 * @param title the player's name of it
 * @param x left edge, logical px
 * @param y upper edge
 * @param width px
 * @param height px
 */
record Chip(EffectReason reason, String title, double x, double y, double width, double height) {

    /** The height in a desktop window, px. */
    static final double HEIGHT = 30;

    private static final double SHARE_HEIGHT = 3;

    /** The height in a window, px. */
    static double height(Layout layout) {
        return layout.clickable(HEIGHT);
    }

    Effect effect() {
        return reason.effect();
    }

    boolean holds(double px, double py) {
        return px >= x && px <= x + width && py >= y && py <= y + height;
    }

    /** Returns this chip displaced, px. */
    Chip movedBy(double dx, double dy) {
        return new Chip(reason, title, x + dx, y + dy, width, height);
    }

    /** Lit when simulated, with a line as long as its share of a step; framed when switched. */
    void draw(Canvas canvas, boolean isLit, boolean isSwitched, double share) {
        canvas.panel(x, y, width, height, height / 2, isLit ? Color.BRASS : Color.PANEL_LIT);
        double line = Math.max(0, Math.min(1, share)) * (width - height);
        if (isLit && line >= 1) {
            double left = x + height / 2;
            double foot = y + height - SHARE_HEIGHT - 1;
            canvas.panel(left, foot, line, SHARE_HEIGHT, 1, Color.RUBBER);
        }
        if (isSwitched) {
            canvas.frame(x - 1, y - 1, width + 2, height + 2, height / 2 + 1, Color.BAD);
        }
        canvas.text(
                title,
                x + width / 2,
                y + height / 2 - 1,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                isLit ? Color.DUSK_TOP : Color.TEXT_DIM);
    }
}
