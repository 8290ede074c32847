package rigibo.frontend.puzzle.show;

import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.widget.Sign;

/** The cooldown as a ring that is full when the next click is allowed. */
public final class CooldownRing {

    private static final double BAR_RADIUS = 13;
    private static final double POINTER_RADIUS = 16;
    private static final double WIDTH = 5;

    private CooldownRing() {}

    /** Draws the ring at the pointer while the cooldown runs; px. */
    static void drawAtPointer(
            Canvas canvas, double x, double y, PuzzleGame game, Refusal refusal, Motion motion) {
        if (game.cooldownLeft() > 0) {
            draw(canvas, x + aside(refusal, motion), y, POINTER_RADIUS, game);
        }
    }

    /** Draws the ring in the bar, with a tick once the next click is allowed; px. */
    public static void drawInBar(
            Canvas canvas, double x, double y, PuzzleGame game, Refusal refusal, Motion motion) {
        draw(canvas, x + aside(refusal, motion), y, BAR_RADIUS, game);
        if (game.cooldownLeft() == 0) {
            Sign.tick(canvas, x, y, 5, 2.5, Color.GOOD);
        }
    }

    /** Sideways displacement of the ring, which shakes when a click comes too early, px. */
    private static double aside(Refusal refusal, Motion motion) {
        return refusal.is(Refusal.Reason.COOLING_DOWN) ? refusal.shake(motion) : 0;
    }

    private static void draw(Canvas canvas, double x, double y, double radius, PuzzleGame game) {
        double left = game.cooldownLeft();
        canvas.ring(x, y, radius, WIDTH, 1, Color.PANEL_LIT);
        canvas.ring(x, y, radius, WIDTH, 1 - left, left > 0 ? Color.BRASS : Color.GOOD);
    }
}
