package rigibo.frontend.draw;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSObject;
import org.teavm.jso.canvas.CanvasRenderingContext2D;
import org.teavm.jso.core.JSString;

import java.util.HashMap;
import java.util.Map;

/**
 * A typeface of the page. Sizes are those of NanoVG, from the lowest to the highest point of the
 * face; the browser's are those of the em square.
 */
final class Typeface {

    /** Size of measured texts, px of the browser. */
    private static final double SAMPLE = 100;

    /** Most widths that are cached. */
    private static final int MOST = 4_000;

    private final String name;

    /** The style of measured texts. */
    private final String sample;

    /** The browser's size for each px of ours. */
    private final double share;

    /** Distance from the middle of the height down to the baseline, for each px. */
    private final double drop;

    /** Width of every letter of size 1 px in a monospaced face, or 0. */
    private final double letter;

    /** Widths of texts of size 1 px. */
    private final Map<String, Double> widths = new HashMap<>();

    private final Map<Double, String> styles = new HashMap<>();

    Typeface(String name) {
        this.name = name;
        CanvasRenderingContext2D pen = Paper.pen();
        sample = SAMPLE + "px " + name;
        Paper.writeIn(sample);
        double above = above(pen);
        double below = below(pen);
        share = SAMPLE / (above + below);
        drop = (above - below) / 2 / (above + below);
        double narrow = measured("i");
        letter = narrow == measured("W") ? narrow : 0;
    }

    double drop(double size) {
        return drop * size;
    }

    /** The style of a size for the browser. */
    String style(double size) {
        return styles.computeIfAbsent(size, px -> share * px + "px " + name);
    }

    double width(String words, double size) {
        if (letter > 0 && isPlain(words)) {
            return size * letter * words.length();
        }
        if (widths.size() > MOST) {
            widths.clear();
        }
        return size * widths.computeIfAbsent(words, this::measured);
    }

    /** Whether a text is printable ASCII, so that this typeface writes all of it. */
    private static boolean isPlain(String words) {
        for (int i = 0; i < words.length(); i++) {
            if (words.charAt(i) < ' ' || words.charAt(i) > '~') {
                return false;
            }
        }
        return true;
    }

    private double measured(String words) {
        Paper.writeIn(sample);
        return share * width(Paper.pen(), Paper.text(words)) / SAMPLE;
    }

    @JSBody(
            params = {"pen", "words"},
            script = "return pen.measureText(words).width;")
    private static native double width(JSObject pen, JSString words);

    @JSBody(params = "pen", script = "return pen.measureText('x').fontBoundingBoxAscent;")
    private static native double above(JSObject pen);

    @JSBody(params = "pen", script = "return pen.measureText('x').fontBoundingBoxDescent;")
    private static native double below(JSObject pen);
}
