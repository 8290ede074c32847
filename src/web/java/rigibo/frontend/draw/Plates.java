package rigibo.frontend.draw;

import org.teavm.jso.JSBody;
import org.teavm.jso.JSObject;

import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;

/** Filled rectangles with round corners, drawn at once. */
final class Plates {

    /** A rectangle from its upper left corner, logical px. */
    void add(double x, double y, double width, double height, double corner, Color color) {
        Paper.fillWith(color);
        fill(Paper.pen(), x, y, width, height, Math.min(corner, Math.min(width, height) / 2));
    }

    /** Does nothing: plates are drawn at once. */
    void draw(Layout layout) {}

    void free() {}

    @JSBody(
            params = {"pen", "x", "y", "width", "height", "corner"},
            script =
                    "if (corner > 0) {"
                            + "pen.beginPath(); pen.roundRect(x, y, width, height, corner);"
                            + "pen.fill(); } else { pen.fillRect(x, y, width, height); }")
    private static native void fill(
            JSObject pen, double x, double y, double width, double height, double corner);
}
