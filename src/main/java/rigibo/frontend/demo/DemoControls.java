package rigibo.frontend.demo;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Key;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Tap;
import rigibo.frontend.scene.widget.Panel;
import rigibo.frontend.scene.widget.Plate;
import rigibo.frontend.scene.widget.Widget;

import java.util.List;
import java.util.function.Predicate;

/**
 * A demo's controls and readouts. They share a plate, except in a handheld window, where there is
 * no room for both.
 */
final class DemoControls {

    /** Width over the scene with text of its usual size, px. */
    static final double WIDTH = 270;

    private final Panel all;
    private final Panel controls;
    private final Panel numbers;

    /** The plate that is shown, or was last. */
    private Panel shown;

    private boolean isDrawn;

    DemoControls(List<Widget> widgets) {
        all = panel(widgets, any -> true);
        controls = panel(widgets, Widget::isControl);
        numbers = panel(widgets, widget -> !widget.isControl());
        shown = all;
    }

    private static Panel panel(List<Widget> widgets, Predicate<Widget> wanted) {
        return new Panel(0, 0, WIDTH, widgets.stream().filter(wanted).toList());
    }

    /** Draws them all, below a point and as wide as told, px. */
    void draw(Canvas canvas, double x, double y, double width) {
        shown = all;
        shown.place(x, y, width);
        shown.draw(canvas);
        isDrawn = true;
    }

    /** Draws the controls alone. */
    void drawControls(Canvas canvas, Plate room) {
        draw(canvas, controls, room);
    }

    /** Draws the readouts alone. */
    void drawNumbers(Canvas canvas, Plate room) {
        draw(canvas, numbers, room);
    }

    private void draw(Canvas canvas, Panel panel, Plate room) {
        shown = panel;
        shown.place(room);
        shown.draw(canvas);
        isDrawn = true;
    }

    /** They cannot be pressed until they are drawn again. */
    void hide() {
        shown.place(0, 0, Plate.NONE.width());
        isDrawn = false;
    }

    /** Tells of them if they are drawn. */
    void describe(Narrator narrator) {
        if (isDrawn) {
            shown.describe(narrator);
        }
    }

    boolean contains(double x, double y) {
        return shown.contains(x, y);
    }

    /** When a finger at a point, px, presses. */
    Tap tap(double x, double y) {
        return shown.tap(x, y);
    }

    void pointerMoved(double x, double y) {
        shown.pointerMoved(x, y);
    }

    void pointerPressed(double x, double y) {
        shown.pointerPressed(x, y);
    }

    void pointerReleased() {
        shown.pointerReleased();
    }

    /** Handles a key; returns whether it is one of theirs. */
    boolean keyPressed(Key key) {
        return shown.keyPressed(key);
    }
}
