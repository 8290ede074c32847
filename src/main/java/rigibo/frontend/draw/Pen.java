package rigibo.frontend.draw;

import static org.lwjgl.nanovg.NanoVG.*;
import static org.lwjgl.nanovg.NanoVGGL3.*;

import org.lwjgl.nanovg.NVGColor;

import rigibo.frontend.scene.Canvas.Align;
import rigibo.frontend.scene.Canvas.Font;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.DisplayException;
import rigibo.frontend.scene.Layout;

/** Text, lines, rings and graphs by NanoVG. */
final class Pen {

    private static final String WORDS = "words";
    private static final String NUMBERS = "numbers";

    private final long context = nvgCreate(NVG_ANTIALIAS);
    private final NVGColor ink = NVGColor.create();

    Pen() {
        if (context == 0) {
            throw new DisplayException("RigiBo cannot draw: NanoVG does not start on this OpenGL");
        }
        load(WORDS, "fonts/Quicksand-Bold.ttf");
        load(NUMBERS, "fonts/JetBrainsMono-Medium.ttf");
    }

    private void load(String name, String file) {
        if (nvgCreateFont(context, name, Assets.font(file).toString()) < 0) {
            throw Assets.broken(file, "is no font");
        }
    }

    void begin(Layout layout) {
        nvgBeginFrame(
                context, (float) layout.width(), (float) layout.height(), (float) layout.ratio());
        nvgTranslate(context, (float) -layout.left(), (float) -layout.top());
    }

    void end() {
        nvgEndFrame(context);
    }

    void free() {
        nvgDelete(context);
    }

    void line(double x1, double y1, double x2, double y2, double width, Color color) {
        nvgBeginPath(context);
        nvgMoveTo(context, (float) x1, (float) y1);
        nvgLineTo(context, (float) x2, (float) y2);
        stroke(width, color);
    }

    void curve(double[] xy, int points, double width, Color color) {
        nvgBeginPath(context);
        nvgMoveTo(context, (float) xy[0], (float) xy[1]);
        for (int i = 1; i < points; i++) {
            nvgLineTo(context, (float) xy[2 * i], (float) xy[2 * i + 1]);
        }
        nvgLineJoin(context, NVG_ROUND);
        stroke(width, color);
        nvgLineJoin(context, NVG_MITER);
    }

    void disc(double x, double y, double radius, Color color) {
        nvgBeginPath(context);
        nvgCircle(context, (float) x, (float) y, (float) radius);
        nvgFillColor(context, ink(color));
        nvgFill(context);
    }

    void ring(double x, double y, double radius, double width, double fraction, Color color) {
        if (fraction <= 0) {
            return;
        }
        double from = -Math.PI / 2;
        double to = from + 2 * Math.PI * Math.min(1, fraction);
        nvgBeginPath(context);
        nvgArc(context, (float) x, (float) y, (float) radius, (float) from, (float) to, NVG_CW);
        nvgLineCap(context, NVG_ROUND);
        stroke(width, color);
    }

    void frame(double x, double y, double width, double height, double corner, Color color) {
        rectangle(x, y, width, height, corner);
        stroke(1.5, color);
    }

    void text(String words, double x, double y, double size, Font font, Align align, Color color) {
        face(size, font);
        int horizontal =
                switch (align) {
                    case LEFT -> NVG_ALIGN_LEFT;
                    case CENTRE -> NVG_ALIGN_CENTER;
                    case RIGHT -> NVG_ALIGN_RIGHT;
                };
        nvgTextAlign(context, horizontal | NVG_ALIGN_MIDDLE);
        nvgFillColor(context, ink(color));
        nvgText(context, (float) x, (float) y, words);
    }

    double textWidth(String words, double size, Font font) {
        face(size, font);
        nvgTextAlign(context, NVG_ALIGN_LEFT);
        return nvgTextBounds(context, 0, 0, words, (float[]) null);
    }

    void graph(double[] values, int count, double x, double y, double w, double h, Color color) {
        if (count < 2) {
            return;
        }
        nvgBeginPath(context);
        for (int i = 0; i < count; i++) {
            float px = (float) (x + w * i / (count - 1));
            float py = (float) (y + h * (1 - Math.max(0, Math.min(1, values[i]))));
            if (i == 0) {
                nvgMoveTo(context, px, py);
            } else {
                nvgLineTo(context, px, py);
            }
        }
        stroke(2, color);
    }

    private void face(double size, Font font) {
        nvgFontFace(context, font == Font.WORDS ? WORDS : NUMBERS);
        nvgFontSize(context, (float) size);
    }

    private void rectangle(double x, double y, double width, double height, double corner) {
        nvgBeginPath(context);
        nvgRoundedRect(
                context, (float) x, (float) y, (float) width, (float) height, (float) corner);
    }

    private void stroke(double width, Color color) {
        nvgStrokeWidth(context, (float) width);
        nvgStrokeColor(context, ink(color));
        nvgStroke(context);
    }

    private NVGColor ink(Color color) {
        return nvgRGBAf(color.red(), color.green(), color.blue(), color.alpha(), ink);
    }
}
