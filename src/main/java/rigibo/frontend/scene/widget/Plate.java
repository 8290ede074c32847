package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Layout;

/**
 * A rectangle on the screen that something is drawn on, logical px.
 *
 * @param x left edge
 * @param y upper edge
 * @param width 0 or more
 * @param height 0 or more
 */
public record Plate(double x, double y, double width, double height) {

    /** Holds no point. */
    public static final Plate NONE = new Plate(0, 0, -1, -1);

    /** The visible part of a window without a margin, px. */
    public static Plate seen(Layout layout, double margin) {
        double left = layout.seenLeft() + margin;
        double top = layout.seenTop() + margin;
        return new Plate(
                left, top, layout.seenRight() - margin - left, layout.seenBottom() - margin - top);
    }

    /** A plate as wide as this one, a gap below it, px. */
    public Plate below(double gap, double height) {
        return new Plate(x, bottom() + gap, width, height);
    }

    /** Right edge. */
    public double right() {
        return x + width;
    }

    /** Lower edge. */
    public double bottom() {
        return y + height;
    }

    /** A button that is here, used in its middle. */
    public Control button(String name, boolean isChosen) {
        return control(name, Control.Kind.BUTTON, 0.5, isChosen);
    }

    /** A control that is here, used at a share of the width. */
    public Control control(String name, Control.Kind kind, double share, boolean isChosen) {
        return new Control(name, kind, x, y, width, height, share, isChosen);
    }

    /** Whether a point lies on it. */
    public boolean contains(double px, double py) {
        return px >= x && px <= right() && py >= y && py <= bottom();
    }
}
