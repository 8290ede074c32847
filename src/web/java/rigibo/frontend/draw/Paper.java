package rigibo.frontend.draw;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSObject;
import org.teavm.jso.canvas.CanvasRenderingContext2D;
import org.teavm.jso.core.JSString;

import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;

import java.util.HashMap;
import java.util.Map;

/**
 * The two-dimensional canvas above that of WebGL. Colours and words that are passed to the browser
 * again and again are converted once.
 */
public final class Paper {

    /** Most texts that are cached: rising numbers are new texts in every picture. */
    private static final int MOST_TEXTS = 2_000;

    private static final Map<Color, JSString> COLORS = new HashMap<>();
    private static final Map<String, JSString> TEXTS = new HashMap<>();

    private static CanvasRenderingContext2D pen;

    /** The canvas's present state; resizing it resets that. */
    private static Color filling;

    private static String style;

    private Paper() {}

    /** Sets the canvas. */
    public static void use(CanvasRenderingContext2D context) {
        pen = context;
    }

    /** Begins a picture. */
    public static void clear() {
        filling = null;
        style = null;
        pen.setTransform(1, 0, 0, 1, 0, 0);
        pen.clearRect(0, 0, pen.getCanvas().getWidth(), pen.getCanvas().getHeight());
    }

    static CanvasRenderingContext2D pen() {
        return pen;
    }

    /** Draws in logical pixels from now on. */
    static void show(Layout layout) {
        double ratio = layout.ratio();
        pen.setTransform(ratio, 0, 0, ratio, -ratio * layout.left(), -ratio * layout.top());
    }

    static void fillWith(Color color) {
        if (!color.equals(filling)) {
            filling = color;
            fillWith(pen, color(color));
        }
    }

    /** Sets the browser's style of letters. */
    static void writeIn(String wanted) {
        if (!wanted.equals(style)) {
            style = wanted;
            writeIn(pen, text(wanted));
        }
    }

    static void strokeWith(double width, Color color) {
        pen.setLineWidth(width);
        strokeWith(pen, color(color));
    }

    static JSString text(String words) {
        if (TEXTS.size() > MOST_TEXTS) {
            TEXTS.clear();
        }
        return TEXTS.computeIfAbsent(words, JSString::valueOf);
    }

    private static JSString color(Color color) {
        if (COLORS.size() > MOST_TEXTS) {
            COLORS.clear();
        }
        return COLORS.computeIfAbsent(color, of -> JSString.valueOf(css(of)));
    }

    private static String css(Color color) {
        return "rgba("
                + Math.round(255 * color.red())
                + ","
                + Math.round(255 * color.green())
                + ","
                + Math.round(255 * color.blue())
                + ","
                + color.alpha()
                + ")";
    }

    @JSBody(
            params = {"pen", "style"},
            script = "pen.fillStyle = style;")
    private static native void fillWith(JSObject pen, JSString style);

    @JSBody(
            params = {"pen", "style"},
            script = "pen.font = style;")
    private static native void writeIn(JSObject pen, JSString style);

    @JSBody(
            params = {"pen", "style"},
            script = "pen.strokeStyle = style;")
    private static native void strokeWith(JSObject pen, JSString style);
}
