package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Layout;
import rigibo.frontend.scene.Narrator;

/** A control or readout that takes one row of a {@link Panel}. */
public sealed interface Widget permits Button, Choice, Slider, Toggle, Readout {

    /** Height of a row in a desktop window, px. */
    double ROW = 30;

    /** Height of a row, px. */
    static double row(Layout layout) {
        return layout.clickable(ROW);
    }

    /** The height that it needs, px. */
    default double height(Layout layout) {
        return row(layout);
    }

    /** Draws the row; {@code isHot} under the pointer or chosen by keys. */
    void draw(Canvas canvas, double x, double y, double width, boolean isHot);

    /** Tells of it where it can be used. */
    default void describe(Narrator narrator, Plate place, boolean isHot) {}

    /** The pointer went down, or was dragged, at a share of the width from 0 to 1. */
    void press(double share);

    /** Whether dragging goes on pressing. */
    default boolean isDragged() {
        return false;
    }

    /** Whether it can be chosen. */
    default boolean isControl() {
        return true;
    }

    /** Its name in links; empty if links do not set it. */
    default String linked() {
        return "";
    }

    /** Its value as text in links. */
    default String setting() {
        return "";
    }

    /** Sets it to what a link says; returns whether that is one of its settings. */
    default boolean set(String setting) {
        return false;
    }

    /** The name in links made from a key of the bundles: the last word of the key. */
    static String linked(String key) {
        return key.substring(key.indexOf('.') + 1);
    }

    /** One notch less (−1) or more (+1), by keys. */
    void nudge(int direction);
}
