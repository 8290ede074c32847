package rigibo.frontend.draw;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSObject;
import org.teavm.jso.canvas.CanvasRenderingContext2D;
import org.teavm.jso.core.JSString;

import java.util.HashMap;
import java.util.Map;

/**
 * A typeface of the page. Sizes are those of NanoVG: the height from the deepest to the highest of
 * the face, where the browser's are of the square that letters are designed in.
 */
final class Typeface {

    /** Size at which is measured, px of the browser. */
    private static final double SAMPLE = 100;

    /** Most widths that are kept. */
    private static final int MOST = 4_000;

    private final String name;

    /** The browser's size for each px of ours. */
    private final double share;

    /** From the middle of the height down to the line that letters stand on, for each px. */
    private final double drop;

    /** Widths of texts of one px. */
    private final Map<String, Double> widths = new HashMap<>();

    private final Map<Double, JSString> styles = new HashMap<>();

    Typeface(String name) {
        this.name = name;
        CanvasRenderingContext2D pen = Paper.pen();
        pen.setFont(SAMPLE + "px " + name);
        double above = above(pen);
        double below = below(pen);
        share = SAMPLE / (above + below);
        drop = (above - below) / 2 / (above + below);
    }

    double drop(double size) {
        return drop * size;
    }

    /** The style of a size for the browser. */
    JSString style(double size) {
        return styles.computeIfAbsent(size, px -> JSString.valueOf(share * px + "px " + name));
    }

    double width(String words, double size) {
        if (widths.size() > MOST) {
            widths.clear();
        }
        return size * widths.computeIfAbsent(words, this::measured);
    }

    private double measured(String words) {
        return share
                * width(Paper.pen(), JSString.valueOf(SAMPLE + "px " + name), Paper.text(words))
                / SAMPLE;
    }

    @JSBody(
            params = {"pen", "style", "words"},
            script = "pen.font = style; return pen.measureText(words).width;")
    private static native double width(JSObject pen, JSString style, JSString words);

    @JSBody(params = "pen", script = "return pen.measureText('x').fontBoundingBoxAscent;")
    private static native double above(JSObject pen);

    @JSBody(params = "pen", script = "return pen.measureText('x').fontBoundingBoxDescent;")
    private static native double below(JSObject pen);
}
