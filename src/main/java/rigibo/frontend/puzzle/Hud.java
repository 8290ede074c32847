package rigibo.frontend.puzzle;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Scene;

import java.util.Locale;

/** What stands above the game: title, clicks and time, the rings, and the panel at the end. */
final class Hud {

    private static final double BAR = 52;
    private static final double MIDDLE = BAR / 2;
    private static final double TITLE_LEFT = 26;
    private static final double TITLE_SIZE = 22;
    private static final double PANEL_WIDTH = 420;
    private static final double PANEL_HEIGHT = 210;
    private static final double PANEL_X = (Scene.WIDTH - PANEL_WIDTH) / 2;

    /** Below what is drawn above the play, px. */
    private static final double PANEL_GAP = 12;

    private final Level level;

    Hud(Level level) {
        this.level = level;
    }

    /** Where the title ends and something else may begin, px. */
    double titleEnd(Canvas canvas) {
        return TITLE_LEFT + canvas.textWidth(title(), TITLE_SIZE, Canvas.Font.WORDS) + 14;
    }

    private String title() {
        return level.title().in(Locale.getDefault());
    }

    /** The bar at the top, with the cooldown's ring. */
    void drawBar(Canvas canvas, Session session) {
        PuzzleGame game = session.game();
        canvas.panel(8, 8, Scene.WIDTH - 16, BAR - 4, 14, Color.PANEL);
        words(canvas, title(), TITLE_LEFT, TITLE_SIZE, Canvas.Align.LEFT, Color.BRASS);
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
                "click a box   R restart   Backspace undo   P pause   E effects   Esc menu",
                Scene.WIDTH / 2.0,
                16,
                Scene.HEIGHT - 18,
                Canvas.Align.CENTRE,
                Color.TEXT);
    }

    /** Below the bar, px. */
    static double foot() {
        return 8 + BAR - 4;
    }

    /** The panel when the game is over, below what is drawn above the play. */
    void drawEnd(Canvas canvas, PuzzleGame game, boolean hasNext, double above) {
        boolean won = game.outcome() == Outcome.WON;
        double top = above + PANEL_GAP;
        Color edge = game.isSolved() ? Color.GOOD : won ? Color.BRASS : Color.BAD;
        canvas.panel(PANEL_X, top, PANEL_WIDTH, PANEL_HEIGHT, 18, Color.PANEL);
        canvas.frame(PANEL_X, top, PANEL_WIDTH, PANEL_HEIGHT, 18, edge);
        String headline = won ? "Solved!" : "Lost: " + game.loss().orElseThrow().words();
        centred(canvas, headline, 34, top + 48, Color.TEXT);
        drawEarned(canvas, game, top + 100);
        String more =
                game.isSolved() && hasNext
                        ? "Enter: next level     R: again"
                        : "R: again     Esc: menu";
        centred(canvas, more, 20, top + PANEL_HEIGHT - 40, Color.BRASS);
    }

    private void drawEarned(Canvas canvas, PuzzleGame game, double y) {
        double centre = Scene.WIDTH / 2.0;
        if (game.isSolved()) {
            drawMedal(canvas, centre, y, Medal.of(game.clicks(), level.limits().par()));
        } else if (game.outcome() == Outcome.WON) {
            centred(canvas, "an experiment: does not count", 22, y, Color.TEXT_DIM);
        } else {
            drawCross(canvas, centre, y);
        }
    }

    private static void centred(Canvas canvas, String words, double size, double y, Color color) {
        words(canvas, words, Scene.WIDTH / 2.0, size, y, Canvas.Align.CENTRE, color);
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
