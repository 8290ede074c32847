package rigibo.frontend.demo;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Words;

import java.util.Locale;

/** Tells what the lines and points of the debug drawing are, with the same marks. */
final class DebugLegend {

    private static final double ROW = 24;
    private static final double PADDING = 10;
    private static final double SIGN = 34;
    private static final double SIZE = 16;

    /** The legend of the debug drawing. */
    enum Mark {
        FIXTURE,
        CONTACT,
        NORMAL,
        FORCE,
        AWAKE,
        ASLEEP;

        private String key() {
            return "debug." + name().toLowerCase(Locale.ROOT);
        }

        private void draw(Canvas canvas, double x, double y) {
            switch (this) {
                case FIXTURE -> canvas.frame(x - 10, y - 7, 20, 14, 0, Color.EDGE);
                case CONTACT -> canvas.disc(x, y, 3, Color.BAD);
                case NORMAL -> canvas.line(x - 10, y, x + 10, y, 1.5, Color.BAD);
                case FORCE -> canvas.line(x - 10, y, x + 10, y, 4, Color.BRASS);
                case AWAKE -> canvas.disc(x, y, 3, Color.GOOD);
                case ASLEEP -> canvas.disc(x, y, 3, Color.TEXT_DIM);
            }
        }
    }

    private DebugLegend() {}

    /** Draws it with its lower left corner at (x, y), px. */
    static void draw(Canvas canvas, Words words, double x, double bottom) {
        double widest = 0;
        for (Mark mark : Mark.values()) {
            double width = canvas.textWidth(words.of(mark.key()), SIZE, Canvas.Font.WORDS);
            widest = Math.max(widest, width);
        }
        double height = Mark.values().length * ROW + 2 * PADDING;
        double top = bottom - height;
        canvas.panel(x, top, widest + SIGN + 2 * PADDING, height, 12, Color.PANEL);
        for (Mark mark : Mark.values()) {
            double middle = top + PADDING + (mark.ordinal() + 0.5) * ROW;
            mark.draw(canvas, x + PADDING + SIGN / 2 - 4, middle);
            canvas.text(
                    words.of(mark.key()),
                    x + PADDING + SIGN,
                    middle,
                    SIZE,
                    Canvas.Font.WORDS,
                    Canvas.Align.LEFT,
                    Color.TEXT);
        }
    }
}
