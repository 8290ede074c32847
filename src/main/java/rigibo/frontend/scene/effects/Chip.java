package rigibo.frontend.scene.effects;

import rigibo.backend.effect.Effect;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

/**
 * The chip of an effect in the bar.
 *
 * @param reason the effect and what it does
 * @param title the player's name of it
 * @param x left edge, logical px
 * @param y upper edge
 * @param width px
 */
record Chip(EffectReason reason, String title, double x, double y, double width) {

    /** px. */
    static final double HEIGHT = 30;

    private static final double SHARE_HEIGHT = 3;

    Effect effect() {
        return reason.effect();
    }

    boolean holds(double px, double py) {
        return px >= x && px <= x + width && py >= y && py <= y + HEIGHT;
    }

    /** Returns this chip displaced, px. */
    Chip movedBy(double dx, double dy) {
        return new Chip(reason, title, x + dx, y + dy, width);
    }

    /** Lit when simulated, with a line as long as its share of a step; framed when switched. */
    void draw(Canvas canvas, boolean isLit, boolean isSwitched, double share) {
        canvas.panel(x, y, width, HEIGHT, HEIGHT / 2, isLit ? Color.BRASS : Color.PANEL_LIT);
        double line = Math.max(0, Math.min(1, share)) * (width - HEIGHT);
        if (isLit && line >= 1) {
            double left = x + HEIGHT / 2;
            double foot = y + HEIGHT - SHARE_HEIGHT - 1;
            canvas.panel(left, foot, line, SHARE_HEIGHT, 1, Color.RUBBER);
        }
        if (isSwitched) {
            canvas.frame(x - 1, y - 1, width + 2, HEIGHT + 2, HEIGHT / 2 + 1, Color.BAD);
        }
        canvas.text(
                title,
                x + width / 2,
                y + HEIGHT / 2 - 1,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                isLit ? Color.DUSK_TOP : Color.TEXT_DIM);
    }
}
