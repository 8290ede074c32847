package rigibo.frontend.puzzle.show;

import rigibo.frontend.puzzle.level.Steps;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Settings.Motion;

/**
 * The ring around the ball that fills while the ball stays on the platform, with a notch for each
 * second. When the ball leaves the platform, the lost part breaks into pieces, visible for a
 * moment.
 */
final class HoldRing {

    private static final int LOST_TURNS = Steps.of(0.6);

    /** Time for which the ring is wider after each full second, s. */
    private static final double TICK = 0.12;

    private static final double WIDTH = 6;

    /**
     * Number of pieces of a full ring. The lost part breaks into pieces of the same angle, so that
     * its shape, too, shows how much was lost.
     */
    private static final int PIECES = 24;

    private final double holdSeconds;
    private double held;
    private double lost;
    private int lostTurns;

    HoldRing(double holdSeconds) {
        this.holdSeconds = holdSeconds;
    }

    /** Called after each step. */
    void observe(PuzzleGame game) {
        double now = game.held();
        if (now < held) {
            lost = held;
            lostTurns = LOST_TURNS;
        }
        held = now;
    }

    /** Called after each frame. */
    void turn() {
        lostTurns = Math.max(0, lostTurns - 1);
    }

    /** Starts again with another game, or with an earlier state of the same one. */
    void reset(PuzzleGame game) {
        held = game.held();
        lostTurns = 0;
    }

    /** Draws the ring around a point of the screen, px. */
    void draw(Canvas canvas, double x, double y, double radius, Motion motion) {
        if (lostTurns > 0) {
            drawLost(canvas, x, y, radius, motion);
        }
        if (held > 0) {
            double seconds = held * holdSeconds;
            boolean ticks = motion == Motion.FULL && seconds % 1 < TICK && seconds >= 1;
            canvas.ring(x, y, radius, WIDTH, 1, Color.PANEL_LIT);
            canvas.ring(x, y, radius, ticks ? WIDTH + 3 : WIDTH, held, Color.GOOD);
            drawNotches(canvas, x, y, radius);
        }
    }

    private void drawNotches(Canvas canvas, double x, double y, double radius) {
        for (int second = 1; second < holdSeconds; second++) {
            spoke(canvas, x, y, radius, second / holdSeconds, Color.DUSK_TOP);
        }
    }

    private void drawLost(Canvas canvas, double x, double y, double radius, Motion motion) {
        double left = lostTurns / (double) LOST_TURNS;
        Color color = Color.BAD.alpha(motion == Motion.FULL ? left : 1);
        double away = motion == Motion.FULL ? 10 * (1 - left) : 0;
        for (int piece = 0; piece < Math.ceil(lost * PIECES); piece++) {
            spoke(canvas, x, y, radius + away, (piece + 0.5) / PIECES, color);
        }
    }

    /** Draws a short line across the ring, at a share of it clockwise from the top. */
    private static void spoke(
            Canvas canvas, double x, double y, double radius, double share, Color color) {
        double angle = 2 * Math.PI * share;
        double right = Math.sin(angle);
        double up = Math.cos(angle);
        double inner = radius - WIDTH / 2;
        double outer = radius + WIDTH / 2;
        canvas.line(x + inner * right, y - inner * up, x + outer * right, y - outer * up, 2, color);
    }
}
