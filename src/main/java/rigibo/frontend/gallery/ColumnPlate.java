package rigibo.frontend.gallery;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.widget.Lines;

import java.util.ArrayList;
import java.util.List;

/** A plate in a column beside a scene, as high as its paragraphs need. */
final class ColumnPlate {

    private static final double PADDING = 14;

    /** Height of a line as a multiple of its text's size. */
    private static final double LEADING = 1.4;

    private final Canvas canvas;
    private final double x;
    private final double width;
    private final List<Line> lines = new ArrayList<>();
    private double height = 2 * PADDING;

    private record Line(String words, double size, Canvas.Font font, Color color) {}

    /** A plate with its left edge at x, px, so wide. */
    ColumnPlate(Canvas canvas, double x, double width) {
        this.canvas = canvas;
        this.x = x;
        this.width = width;
    }

    /** Adds words, broken into lines; nothing where there are none. */
    void add(String words, double size, Canvas.Font font, Color color) {
        if (words.isEmpty()) {
            return;
        }
        for (String line : Lines.of(canvas, words, size, font, width - 2 * PADDING)) {
            lines.add(new Line(line, size, font, color));
            height += pitch(size);
        }
    }

    private double pitch(double size) {
        return LEADING * canvas.layout().textSize(size);
    }

    /** Draws it with its upper edge at y, px; returns its lower edge. */
    double draw(double y) {
        canvas.panel(x, y, width, height, 12, Color.PANEL);
        double top = y + PADDING;
        for (Line line : lines) {
            double middle = top + pitch(line.size) / 2;
            canvas.text(
                    line.words,
                    x + PADDING,
                    middle,
                    line.size,
                    line.font,
                    Canvas.Align.LEFT,
                    line.color);
            top += pitch(line.size);
        }
        return y + height;
    }
}
