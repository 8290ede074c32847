package rigibo.frontend.display;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Scene;

/** A short message about the window itself, shown for a moment over any scene. */
final class Toast {

    /** Time for which it is shown, in frames of 1/60 s. */
    private static final int FRAMES = 90;

    private static final double SIZE = 18;
    private static final double HEIGHT = 40;
    private static final double EDGE = 8;
    private static final double PADDING = 20;

    private String words = "";
    private int left;

    /** Shows a message in place of the last one. */
    void say(String now) {
        words = now;
        left = FRAMES;
    }

    void draw(Canvas canvas) {
        if (left == 0) {
            return;
        }
        left--;
        double width = canvas.textWidth(words, SIZE, Canvas.Font.WORDS) + 2 * PADDING;
        Layout layout = canvas.layout();
        double middle = layout.isInHand() ? layout.left() + layout.width() / 2 : Scene.WIDTH / 2.0;
        double x = middle - width / 2;
        double height = layout.lettered(HEIGHT);
        double y = top(layout, height);
        canvas.panel(x, y, width, height, height / 2, Color.PANEL_LIT);
        canvas.frame(x, y, width, height, height / 2, Color.BRASS);
        canvas.text(
                words,
                middle,
                y + height / 2,
                SIZE,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                Color.TEXT);
    }

    /**
     * Upper edge, px. The toast lies over what players know best. That is the row of keys at the
     * lower edge, since most scenes have headlines in the upper half. In a handheld window, where
     * thumbs use the lower edge, it is the upper bar.
     */
    private static double top(Layout layout, double height) {
        return layout.isInHand() ? layout.seenTop() + EDGE : layout.seenBottom() - EDGE - height;
    }
}
