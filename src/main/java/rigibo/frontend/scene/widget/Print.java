package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

import java.util.List;

/** Text of a size in px, centred on a point of the screen or beside it. */
public final class Print {

    /** Between two lines of small text, px. */
    private static final double LINE = 20;

    private Print() {}

    /** With its middle at a point. */
    public static void centred(
            Canvas canvas, String words, double x, double y, double size, Color color) {
        canvas.text(words, x, y, size, Canvas.Font.WORDS, Canvas.Align.CENTRE, color);
    }

    /** To the right of a point. */
    public static void left(
            Canvas canvas, String words, double x, double y, double size, Color color) {
        canvas.text(words, x, y, size, Canvas.Font.WORDS, Canvas.Align.LEFT, color);
    }

    /** To the left of a point. */
    public static void right(
            Canvas canvas, String words, double x, double y, double size, Color color) {
        canvas.text(words, x, y, size, Canvas.Font.WORDS, Canvas.Align.RIGHT, color);
    }

    /**
     * The label of a control, with its left end and its middle at a point; in a handheld window it
     * wraps.
     */
    static void label(Canvas canvas, String words, double x, double y, double width, Color color) {
        if (!canvas.layout().isInHand()) {
            left(canvas, words, x, y, 16, color);
            return;
        }
        List<String> lines = Lines.of(canvas, words, 16, Canvas.Font.WORDS, width);
        double pitch = canvas.layout().lettered(LINE);
        double middle = y - (lines.size() - 1) * pitch / 2;
        for (String line : lines) {
            left(canvas, line, x, middle, 16, color);
            middle += pitch;
        }
    }

    /** A button's plate with its word in the middle. */
    public static void button(Canvas canvas, Tile tile, String words, boolean isChosen) {
        plate(canvas, tile, isChosen);
        centred(canvas, words, tile.middleX(), tile.middleY(), 18, Color.TEXT);
    }

    /** A tile's plate, lit and framed where it is chosen. */
    public static void plate(Canvas canvas, Tile tile, boolean isChosen) {
        Color plate = isChosen ? Color.PANEL_LIT : Color.PANEL;
        canvas.panel(tile.x(), tile.y(), tile.width(), tile.height(), 12, plate);
        if (isChosen) {
            canvas.frame(tile.x(), tile.y(), tile.width(), tile.height(), 12, Color.BRASS);
        }
    }
}
