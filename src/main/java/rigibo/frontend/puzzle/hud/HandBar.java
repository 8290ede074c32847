package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.level.Level;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.show.CooldownRing;
import rigibo.frontend.puzzle.show.Refusal;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Medal;
import rigibo.frontend.scene.Settings.Motion;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * The bar of a level in a handheld window: title, counts with the cooldown's ring, and below them
 * messages of the game.
 */
final class HandBar {

    private static final double PADDING = 14;
    private static final double TITLE_SIZE = 22;
    private static final double SIZE = 17;

    /**
     * Distances from the right edge to the middle of the ring and to the right end of the counts,
     * px.
     */
    private static final double RING = 32;

    private static final double COUNTS = 60;

    private final Level level;

    HandBar(Level level) {
        this.level = level;
    }

    /**
     * Draws it.
     *
     * @param said the state of the game, if it needs words
     */
    void draw(
            Canvas canvas,
            Plate bar,
            Words words,
            PuzzleGame game,
            Optional<String> said,
            Refusal refusal,
            Motion motion) {
        Layout layout = canvas.layout();
        double line = layout.lettered(HandPlaces.LINE);
        canvas.panel(bar.x(), bar.y(), bar.width(), bar.height(), 14, Color.PANEL);
        double left = bar.x() + PADDING;
        double middle = bar.y() + PADDING / 2 + line / 2;
        CooldownRing.drawInBar(canvas, bar.right() - RING, bar.y() + RING, game, refusal, motion);
        Color ink = refusal.is(Refusal.Reason.NO_CLICKS_LEFT) ? Color.BAD : Color.TEXT;
        String counts = Counts.counts(words, level.limits(), game);
        double room = bar.width() - COUNTS - PADDING;
        if (layout.isUpright()) {
            canvas.text(
                    counts,
                    bar.right() - COUNTS,
                    middle,
                    SIZE,
                    Canvas.Font.NUMBERS,
                    Canvas.Align.RIGHT,
                    ink);
            room -= canvas.textWidth(counts, SIZE, Canvas.Font.NUMBERS) + PADDING;
        }
        String title = level.title().in(words.locale());
        String fitting = Lines.shortened(canvas, title, TITLE_SIZE, Canvas.Font.WORDS, room);
        Print.left(canvas, fitting, left, middle, TITLE_SIZE, Color.BRASS);
        List<Line> below = new ArrayList<>();
        double width = bar.width() - 2 * PADDING;
        if (!layout.isUpright()) {
            add(below, canvas, counts, ink, width);
        }
        said.ifPresent(state -> add(below, canvas, state, Color.TEXT, width));
        medal(words, game).ifPresent(it -> add(below, canvas, it.words, it.ink, width));
        for (Line one : below) {
            middle += line;
            if (middle + line / 2 > bar.bottom()) {
                return;
            }
            Print.left(canvas, one.words, left, middle, SIZE, one.ink);
        }
    }

    /** Words in a colour. */
    private record Line(String words, Color ink) {}

    private static void add(
            List<Line> lines, Canvas canvas, String words, Color ink, double width) {
        Lines.of(canvas, words, SIZE, Canvas.Font.WORDS, width)
                .forEach(line -> lines.add(new Line(line, ink)));
    }

    /** The best medal still within reach. */
    private Optional<Line> medal(Words words, PuzzleGame game) {
        if (game.isExperiment()) {
            return Optional.empty();
        }
        int par = level.limits().par();
        Medal best = Medal.of(game.clicks(), par);
        String still = words.of("puzzle.still." + Command.key(best), par, par + 1);
        return Optional.of(new Line(still, best.color()));
    }
}
