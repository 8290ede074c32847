package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.replay.Recording;
import rigibo.frontend.puzzle.replay.Verdict;
import rigibo.frontend.puzzle.rules.Act;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.show.View;
import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

import java.util.ArrayList;
import java.util.List;

/** The controls around a replay: title, counts, a time line with its clicks, and keys. */
public final class ReplayBar {

    private static final double EDGE = 8;
    private static final double INNER = Scene.WIDTH - 2 * EDGE;
    private static final double HEIGHT = View.BAR_FOOT - EDGE;
    private static final double MIDDLE = EDGE + 20;
    private static final double LEFT = EDGE + 18;
    private static final double RIGHT = Scene.WIDTH - LEFT;
    private static final double TITLE_SIZE = 22;
    private static final double WORDS_SIZE = 17;
    private static final double GAP = 14;

    /** Position of the time line, y in px. */
    private static final double TIME_Y = View.BAR_FOOT - 9;

    private static final double KEYS_Y = (View.KEYS_TOP + Scene.HEIGHT) / 2;

    private static final double KEYS_SIZE = 16;
    private static final double LINE = 25;

    private static final double LINE_IN_HAND = 21;
    private static final double PADDING = 10;

    private final Recording recording;

    public ReplayBar(Recording recording) {
        this.recording = recording;
    }

    /** Draws the bar; {@code state} describes the playback. */
    public void draw(Canvas canvas, Words words, PuzzleGame game, String state) {
        canvas.panel(EDGE, EDGE, INNER, HEIGHT, 14, Color.PANEL);
        String title = recording.level().title().in(words.locale());
        text(canvas, title, LEFT, TITLE_SIZE, Color.BRASS);
        double left = LEFT + canvas.textWidth(title, TITLE_SIZE, Canvas.Font.WORDS) + GAP;
        text(canvas, state, left, WORDS_SIZE, Color.TEXT);
        canvas.text(
                Counts.counts(words, recording.level().limits(), game),
                RIGHT,
                MIDDLE,
                WORDS_SIZE,
                Canvas.Font.NUMBERS,
                Canvas.Align.RIGHT,
                Color.TEXT);
        drawTime(canvas, game, LEFT, RIGHT - LEFT, TIME_Y);
    }

    /**
     * Draws the parts one below the other at the upper edge of a handheld window, px; returns their
     * lower edge.
     */
    public double drawInHand(
            Canvas canvas, Plate room, Words words, PuzzleGame game, String state) {
        List<String> said = new ArrayList<>();
        said.add(recording.level().title().in(words.locale()));
        said.add(state);
        said.add(Counts.counts(words, recording.level().limits(), game));
        double inner = room.width() - 2 * PADDING;
        List<String> lines =
                said.stream()
                        .flatMap(
                                one ->
                                        Lines.of(canvas, one, KEYS_SIZE, Canvas.Font.WORDS, inner)
                                                .stream())
                        .toList();
        double height = lines.size() * LINE_IN_HAND + 3 * PADDING;
        canvas.panel(room.x(), room.y(), room.width(), height, 14, Color.PANEL);
        double left = room.x() + PADDING;
        double y = room.y() + PADDING + LINE_IN_HAND / 2;
        for (String line : lines) {
            Color ink = line.equals(said.get(0)) ? Color.BRASS : Color.TEXT;
            Print.left(canvas, line, left, y, KEYS_SIZE, ink);
            y += LINE_IN_HAND;
        }
        double end = room.y() + height;
        drawTime(canvas, game, left, inner, end - PADDING);
        return end;
    }

    private void drawTime(Canvas canvas, PuzzleGame game, double left, double width, double y) {
        double share = Math.min(1, game.steps() / (double) recording.steps());
        canvas.line(left, y, left + width, y, 3, Color.PANEL_LIT);
        canvas.line(left, y, left + share * width, y, 3, Color.BRASS);
        for (Act act : recording.replay().acts()) {
            double x = left + act.step() / (double) recording.steps() * width;
            canvas.line(x, y - 5, x, y + 5, 3, Color.TEXT);
        }
    }

    /**
     * Draws the keys below the play, and over its lower edge where they need more than one line.
     */
    public void drawKeys(Canvas canvas, Words words) {
        List<String> lines =
                Lines.ofGroups(canvas, words.of("replay.keys"), KEYS_SIZE, Scene.WIDTH - 2 * EDGE);
        double above = (lines.size() - 1) * LINE;
        if (above > 0) {
            canvas.panel(EDGE, View.KEYS_TOP - above, INNER, Scene.HEIGHT, 14, Color.PANEL);
        }
        double y = KEYS_Y - above;
        for (String line : lines) {
            Print.centred(canvas, line, Scene.WIDTH / 2.0, y, KEYS_SIZE, Color.TEXT);
            y += LINE;
        }
    }

    /** Draws the verdict of the replay below a bar that ends at a height, px. */
    public void drawVerdict(Canvas canvas, Words words, Verdict verdict, double end) {
        VerdictPlate.draw(canvas, words, verdict, end);
    }

    private static void text(Canvas canvas, String words, double x, double size, Color color) {
        canvas.text(words, x, MIDDLE, size, Canvas.Font.WORDS, Canvas.Align.LEFT, color);
    }
}
