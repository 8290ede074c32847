package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.level.Limits;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;

import java.util.List;

/**
 * Clicks and time in the bar, over the best medal still within reach; a plate explains them while
 * the pointer is on them.
 */
final class Counts {

    private static final double SIZE = 16;

    /** Distance from the middle of the bar to those of the two lines, px. */
    private static final double ASIDE = 11;

    /** Margins of the explaining plate, px. */
    private static final double EDGE = 8;

    private static final double WIDTH = 380;
    private static final double PADDING = 14;
    private static final double LINE = 24;

    private final Limits limits;

    Counts(Limits limits) {
        this.limits = limits;
    }

    /**
     * Draws both lines, with their right ends at a place, px.
     *
     * @param clicks the colour of the clicks
     * @return their left edge, px
     */
    double draw(Canvas canvas, Words words, PuzzleGame game, double right, double y, Color clicks) {
        String counts = counts(words, limits, game);
        canvas.text(
                counts, right, y - ASIDE, SIZE, Canvas.Font.NUMBERS, Canvas.Align.RIGHT, clicks);
        double wide = canvas.textWidth(counts, SIZE, Canvas.Font.NUMBERS);
        if (game.isExperiment()) {
            return right - wide;
        }
        Medal best = Medal.of(game.clicks(), limits.par());
        String medal =
                words.of("puzzle.still." + Command.key(best), limits.par(), limits.par() + 1);
        Print.right(canvas, medal, right, y + ASIDE, SIZE, best.color());
        return right - Math.max(wide, canvas.textWidth(medal, SIZE, Canvas.Font.WORDS));
    }

    /** The clicks, with their limit if there is one, and the time. */
    static String counts(Words words, Limits limits, PuzzleGame game) {
        return limits.maxClicks().isPresent()
                ? words.of(
                        "puzzle.counts.limited",
                        game.clicks(),
                        game.seconds(),
                        limits.maxClicks().getAsInt())
                : words.of("puzzle.counts", game.clicks(), game.seconds());
    }

    /** Draws the plate that explains medals, cooldown and hold below the bar. */
    void drawHelp(Canvas canvas, Words words) {
        String told =
                words.of(
                        "puzzle.counts.help",
                        limits.par(),
                        limits.par() + 1,
                        limits.cooldown(),
                        limits.hold());
        Layout layout = canvas.layout();
        double width = layout.lettered(WIDTH);
        double pitch = layout.lettered(LINE);
        List<String> lines = Lines.of(canvas, told, SIZE, Canvas.Font.WORDS, width - 2 * PADDING);
        double left = Scene.WIDTH - EDGE - width;
        double top = View.BAR_FOOT + 4;
        canvas.panel(left, top, width, lines.size() * pitch + PADDING, 12, Color.NIGHT);
        double y = top + PADDING / 2 + pitch / 2;
        for (String line : lines) {
            Print.left(canvas, line, left + PADDING, y, SIZE, Color.TEXT);
            y += pitch;
        }
    }
}
