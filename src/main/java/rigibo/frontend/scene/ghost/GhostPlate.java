package rigibo.frontend.scene.ghost;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;
import rigibo.frontend.scene.widget.Lines;

/** The distance between a ghost and its scene: a number, a curve, and an explanation. */
public final class GhostPlate {

    /** px. */
    public static final double HEIGHT = 248;

    private static final double MARGIN = 12;
    private static final double SIZE = 16;
    private static final double LINE = 22;
    private static final double HEAD = 18;
    private static final double CURVE_TOP = 52;
    private static final double CURVE_HEIGHT = 126;

    private final Words words;
    private final DistanceCurve curve = new DistanceCurve();

    /** A plate in a player's words. */
    public GhostPlate(Words words) {
        this.words = words;
    }

    /** Draws it with its upper left corner at (x, y), px. */
    public void draw(Canvas canvas, Ghost ghost, double x, double y, double width) {
        Divergence divergence = ghost.divergence();
        double left = x + MARGIN;
        double right = x + width - MARGIN;
        canvas.panel(x, y, width, HEIGHT, 12, Color.PANEL);
        words(canvas, words.of("ghost.from", ghost.preset()), left, y + HEAD, Color.TEXT);
        words(canvas, words.of("ghost.rms"), left, y + HEAD + LINE, Color.TEXT_DIM);
        canvas.text(
                Metres.words(words, divergence.distance()),
                right,
                y + HEAD,
                SIZE,
                Canvas.Font.NUMBERS,
                Canvas.Align.RIGHT,
                Color.TEXT);
        curve.draw(canvas, divergence, left, y + CURVE_TOP, right - left, CURVE_HEIGHT);
        boolean isParted = divergence.parting().isPresent();
        String note =
                divergence
                        .parting()
                        .map(parting -> parting.briefIn(words))
                        .orElse(words.of("ghost.open"));
        double line = y + CURVE_TOP + CURVE_HEIGHT + 8 + LINE / 2;
        for (String part : Lines.of(canvas, note, SIZE, Canvas.Font.WORDS, right - left)) {
            words(canvas, part, left, line, isParted ? Color.BRASS : Color.TEXT);
            line += LINE;
        }
    }

    private static void words(Canvas canvas, String words, double x, double y, Color color) {
        canvas.text(words, x, y, SIZE, Canvas.Font.WORDS, Canvas.Align.LEFT, color);
    }
}
