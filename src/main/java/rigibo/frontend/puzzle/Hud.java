package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;

import java.util.Locale;

/** What stands above the game: title, clicks and time, the rings, and the panel at the end. */
final class Hud {

    private static final double BAR = 52;
    private static final double MIDDLE = BAR / 2;
    private static final double PANEL_WIDTH = 420;
    private static final double PANEL_HEIGHT = 210;
    private static final double PANEL_X = (Scene.WIDTH - PANEL_WIDTH) / 2;
    private static final double PANEL_Y = 76;

    private final Level level;

    Hud(Level level) {
        this.level = level;
    }

    /** The bar at the top, with the cooldown's ring. */
    void drawBar(Canvas canvas, Session session) {
        PuzzleGame game = session.game();
        canvas.panel(8, 8, Scene.WIDTH - 16, BAR - 4, 14, Color.PANEL);
        words(
                canvas,
                level.title().in(Locale.getDefault()),
                26,
                22,
                Canvas.Align.LEFT,
                Color.BRASS);
        String counts =
                String.format(
                        Locale.ROOT,
                        "%d/%d clicks  %5.1f s",
                        game.clicks(),
                        level.limits().par(),
                        game.seconds());
        canvas.text(
                counts,
                Scene.WIDTH - 70,
                MIDDLE + 6,
                18,
                Canvas.Font.NUMBERS,
                Canvas.Align.RIGHT,
                Color.TEXT);
        drawCooldown(canvas, Scene.WIDTH - 38, MIDDLE + 6, 13, game);
        String state = state(session);
        words(canvas, state, Scene.WIDTH / 2.0, 18, Canvas.Align.CENTRE, Color.TEXT);
    }

    private static String state(Session session) {
        if (session.isPaused()) {
            return "paused";
        }
        return switch (session.pace()) {
            case FULL -> "";
            case HALF -> "half speed";
            case QUARTER -> "quarter speed";
        };
    }

    /** The cooldown as a ring: full when the next click is allowed. */
    void drawCooldown(Canvas canvas, double x, double y, double radius, PuzzleGame game) {
        double left = game.cooldownLeft();
        canvas.ring(x, y, radius, 5, 1, Color.PANEL_LIT);
        canvas.ring(x, y, radius, 5, 1 - left, left > 0 ? Color.BRASS : Color.GOOD);
    }

    /** Keys, at the bottom. */
    void drawKeys(Canvas canvas) {
        words(
                canvas,
                "click a box   R restart   Backspace undo   P pause   Esc menu",
                Scene.WIDTH / 2.0,
                16,
                Scene.HEIGHT - 18,
                Canvas.Align.CENTRE,
                Color.TEXT);
    }

    /** The panel when the game is over. */
    void drawEnd(Canvas canvas, PuzzleGame game, boolean hasNext) {
        boolean won = game.outcome() == Outcome.WON;
        canvas.panel(PANEL_X, PANEL_Y, PANEL_WIDTH, PANEL_HEIGHT, 18, Color.PANEL);
        canvas.frame(PANEL_X, PANEL_Y, PANEL_WIDTH, PANEL_HEIGHT, 18, won ? Color.GOOD : Color.BAD);
        double centre = Scene.WIDTH / 2.0;
        String headline = won ? "Solved!" : "Lost: " + game.loss().orElseThrow().words();
        words(canvas, headline, centre, 34, PANEL_Y + 48, Canvas.Align.CENTRE, Color.TEXT);
        if (won) {
            drawMedal(canvas, centre, PANEL_Y + 100, Medal.of(game.clicks(), level.limits().par()));
        } else {
            drawCross(canvas, centre, PANEL_Y + 100);
        }
        String more = won && hasNext ? "Enter: next level     R: again" : "R: again     Esc: menu";
        words(
                canvas,
                more,
                centre,
                20,
                PANEL_Y + PANEL_HEIGHT - 40,
                Canvas.Align.CENTRE,
                Color.BRASS);
    }

    /** One, two or three stars beside the colour, so that colour alone does not tell. */
    private static void drawMedal(Canvas canvas, double x, double y, Medal medal) {
        Color metal =
                switch (medal) {
                    case GOLD -> Color.of(0xFFD24A);
                    case SILVER -> Color.of(0xD5DAE3);
                    case BRONZE -> Color.of(0xCD8E5C);
                };
        int discs = Medal.values().length - medal.ordinal();
        for (int i = 0; i < discs; i++) {
            double at = x + (i - (discs - 1) / 2.0) * 34 - 60;
            canvas.disc(at, y, 13, metal);
            canvas.disc(at, y, 8, metal.alpha(0.5));
            canvas.ring(at, y, 9, 2, 1, Color.PANEL_LIT);
        }
        words(
                canvas,
                medal.name().toLowerCase(Locale.ROOT),
                x + 14,
                22,
                y,
                Canvas.Align.LEFT,
                metal);
    }

    private static void drawCross(Canvas canvas, double x, double y) {
        canvas.ring(x, y, 20, 4, 1, Color.BAD);
        canvas.line(x - 8, y - 8, x + 8, y + 8, 4, Color.BAD);
        canvas.line(x - 8, y + 8, x + 8, y - 8, 4, Color.BAD);
    }

    private static void words(
            Canvas canvas, String words, double x, double size, Canvas.Align align, Color color) {
        words(canvas, words, x, size, MIDDLE + 6, align, color);
    }

    private static void words(
            Canvas canvas,
            String words,
            double x,
            double size,
            double y,
            Canvas.Align align,
            Color color) {
        canvas.text(words, x, y, size, Canvas.Font.WORDS, align, color);
    }
}
