package rigibo.frontend.laboratory;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.ghost.DistanceCurve;
import rigibo.frontend.scene.ghost.Divergence;
import rigibo.frontend.scene.ghost.Metres;
import rigibo.frontend.scene.widget.Lines;

import java.util.List;

/**
 * The distance between the two halves, now and as a curve, and whether their divergence is chaotic.
 */
final class DistancePlate {

    private static final double PADDING = 12;
    private static final double LINE = 24;
    private static final double SIZE = 16;

    private final DistanceCurve curve = new DistanceCurve();
    private final Words words;
    private final double x;
    private final double y;
    private final double width;
    private final double height;

    /** A plate with its upper left corner at (x, y), px. */
    DistancePlate(Words words, double x, double y, double width, double height) {
        this.words = words;
        this.x = x;
        this.y = y;
        this.width = width;
        this.height = height;
    }

    /** Draws it, with a question in place of the note while there is no chaos. */
    void draw(Canvas canvas, Divergence divergence, String question) {
        canvas.panel(x, y, width, height, 12, Color.PANEL);
        double left = x + PADDING;
        double right = x + width - PADDING;
        double upper = y + 4 + LINE / 2;
        words(canvas, words.of("laboratory.distance"), left, upper, Color.TEXT_DIM);
        canvas.text(
                Metres.words(divergence.distance()),
                right,
                upper,
                SIZE,
                Canvas.Font.NUMBERS,
                Canvas.Align.RIGHT,
                Color.TEXT);
        double top = y + 4 + LINE;
        String note = divergence.parting().map(parting -> parting.in(words)).orElse(question);
        List<String> lines = Lines.of(canvas, note, SIZE, Canvas.Font.WORDS, right - left);
        double foot = lines.size() * LINE;
        curve.draw(canvas, divergence, left, top, right - left, height - LINE - foot - 10);
        double lower = y + height - 3 - foot + LINE / 2;
        Color color = divergence.parting().isPresent() ? Color.BRASS : Color.TEXT;
        for (String line : lines) {
            words(canvas, line, left, lower, color);
            lower += LINE;
        }
    }

    private static void words(Canvas canvas, String words, double x, double y, Color color) {
        canvas.text(words, x, y, SIZE, Canvas.Font.WORDS, Canvas.Align.LEFT, color);
    }
}
