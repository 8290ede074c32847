package rigibo.frontend.puzzle.hud;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.widget.Lines;
import rigibo.frontend.scene.widget.Print;

import java.util.List;

/**
 * A text broken into centred lines.
 *
 * @param lines none for an empty text
 * @param size of the text, px
 * @param pitch from line to line, px
 */
record Paragraph(List<String> lines, double size, double pitch) {

    /**
     * Breaks a text.
     *
     * @param pitch from line to line in a desktop window, px
     * @param width of a line, px
     */
    static Paragraph of(Canvas canvas, String text, double size, double pitch, double width) {
        List<String> lines =
                text.isEmpty() ? List.of() : Lines.of(canvas, text, size, Canvas.Font.WORDS, width);
        return new Paragraph(lines, size, canvas.layout().lettered(pitch));
    }

    /** Lower edge, with the middle of its first line at a height, px. */
    double bottom(double first) {
        return first + (lines.size() - 0.5) * pitch;
    }

    void draw(Canvas canvas, double middle, double first, Color color) {
        for (int i = 0; i < lines.size(); i++) {
            Print.centred(canvas, lines.get(i), middle, first + i * pitch, size, color);
        }
    }
}
