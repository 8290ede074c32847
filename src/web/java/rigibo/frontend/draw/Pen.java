package rigibo.frontend.draw;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSObject;
import org.teavm.jso.canvas.CanvasRenderingContext2D;
import org.teavm.jso.core.JSString;

import rigibo.frontend.scene.Canvas.Align;
import rigibo.frontend.scene.Canvas.Font;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;

/** Text, lines, rings and graphs, drawn at once. */
final class Pen {

    /** Width of the edge of a rectangle, px. */
    private static final double EDGE = 1.5;

    private final CanvasRenderingContext2D pen = Paper.pen();
    private final Typeface words = new Typeface("words");
    private final Typeface numbers = new Typeface("numbers");

    void begin(Layout layout) {
        Paper.show(layout);
        pen.setLineCap("butt");
        pen.setLineJoin("miter");
    }

    void end() {}

    void free() {}

    void line(double x1, double y1, double x2, double y2, double width, Color color) {
        Paper.strokeWith(width, color);
        line(pen, x1, y1, x2, y2);
    }

    void curve(double[] xy, int points, double width, Color color) {
        pen.beginPath();
        pen.moveTo(xy[0], xy[1]);
        for (int i = 1; i < points; i++) {
            pen.lineTo(xy[2 * i], xy[2 * i + 1]);
        }
        pen.setLineJoin("round");
        Paper.strokeWith(width, color);
        pen.stroke();
        pen.setLineJoin("miter");
    }

    void disc(double x, double y, double radius, Color color) {
        pen.beginPath();
        pen.arc(x, y, radius, 0, 2 * Math.PI);
        Paper.fillWith(color);
        pen.fill();
    }

    void ring(double x, double y, double radius, double width, double fraction, Color color) {
        if (fraction <= 0) {
            return;
        }
        double from = -Math.PI / 2;
        pen.beginPath();
        pen.arc(x, y, radius, from, from + 2 * Math.PI * Math.min(1, fraction));
        pen.setLineCap("round");
        Paper.strokeWith(width, color);
        pen.stroke();
        pen.setLineCap("butt");
    }

    void frame(double x, double y, double width, double height, double corner, Color color) {
        Paper.strokeWith(EDGE, color);
        frame(pen, x, y, width, height, Math.min(corner, Math.min(width, height) / 2));
    }

    void text(String text, double x, double y, double size, Font font, Align align, Color color) {
        Typeface face = face(font);
        double width = align == Align.LEFT ? 0 : face.width(text, size);
        double left =
                switch (align) {
                    case LEFT -> x;
                    case CENTRE -> x - width / 2;
                    case RIGHT -> x - width;
                };
        Paper.fillWith(color);
        Paper.writeIn(face.style(size));
        write(pen, Paper.text(text), left, y + face.drop(size));
    }

    double textWidth(String text, double size, Font font) {
        return face(font).width(text, size);
    }

    void graph(double[] values, int count, double x, double y, double w, double h, Color color) {
        if (count < 2) {
            return;
        }
        pen.beginPath();
        for (int i = 0; i < count; i++) {
            double down = 1 - Math.max(0, Math.min(1, values[i]));
            pen.lineTo(x + w * i / (count - 1), y + h * down);
        }
        Paper.strokeWith(2, color);
        pen.stroke();
    }

    private Typeface face(Font font) {
        return font == Font.WORDS ? words : numbers;
    }

    @JSBody(
            params = {"pen", "x1", "y1", "x2", "y2"},
            script = "pen.beginPath(); pen.moveTo(x1, y1); pen.lineTo(x2, y2); pen.stroke();")
    private static native void line(JSObject pen, double x1, double y1, double x2, double y2);

    @JSBody(
            params = {"pen", "x", "y", "width", "height", "corner"},
            script = "pen.beginPath(); pen.roundRect(x, y, width, height, corner); pen.stroke();")
    private static native void frame(
            JSObject pen, double x, double y, double width, double height, double corner);

    @JSBody(
            params = {"pen", "words", "x", "y"},
            script = "pen.fillText(words, x, y);")
    private static native void write(JSObject pen, JSString words, double x, double y);
}
