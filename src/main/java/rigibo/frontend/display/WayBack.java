package rigibo.frontend.display;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Pane;
import rigibo.frontend.scene.Scene;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Print;

/**
 * A button that does what Esc does, for hands that have no keys: in the corner of scenes whose own
 * ways back are keys, or too small.
 */
final class WayBack {

    private static final double GAP = 8;
    private static final double SIZE = 34;

    private WayBack() {}

    /** Where it is in a window that shows a scene; nowhere if that needs none. */
    static Plate place(Pane pane, Layout layout, Scene scene) {
        if (!pane.isInHand() || scene.isForHands()) {
            return Plate.NONE;
        }
        double side = Layout.FINGER * pane.contentScale() / layout.ratio();
        return new Plate(
                layout.left() + pane.hidden().left() / layout.ratio() + GAP,
                layout.top() + pane.hidden().top() / layout.ratio() + GAP,
                side,
                side);
    }

    /** Draws it, if it is anywhere. */
    static void draw(Canvas canvas, Plate place) {
        if (place != Plate.NONE) {
            canvas.panel(place.x(), place.y(), place.width(), place.height(), 14, Color.PANEL_LIT);
            double y = place.y() + place.height() / 2;
            Print.centred(canvas, "‹", place.x() + place.width() / 2, y, SIZE, Color.TEXT);
        }
    }
}
