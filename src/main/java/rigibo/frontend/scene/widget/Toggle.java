package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Narrator;

import java.util.function.BooleanSupplier;

/**
 * Switches something on and off.
 *
 * @param words its label
 * @param isOn the present state
 * @param flip changes it
 */
public record Toggle(String words, BooleanSupplier isOn, Runnable flip) implements Widget {

    @Override
    public void draw(Canvas canvas, double x, double y, double width, boolean isHot) {
        boolean on = isOn.getAsBoolean();
        double middle = y + Widget.row(canvas.layout()) / 2;
        double knob = canvas.layout().lettered(10);
        double left = x + width - 4 * knob;
        Color ink = isHot ? Color.TEXT : Color.TEXT_DIM;
        Print.label(canvas, words, x, middle, left - x - knob, ink);
        Color track = on ? Color.GOOD : Color.PANEL_LIT;
        canvas.panel(left, middle - knob, 4 * knob, 2 * knob, knob, track);
        canvas.disc(x + width - (on ? 1 : 3) * knob, middle, 0.7 * knob, Color.TEXT);
    }

    @Override
    public void describe(Narrator narrator, Plate place, boolean isHot) {
        narrator.offers(place.control(words, Control.Kind.of(isOn.getAsBoolean()), 0.5, isHot));
    }

    @Override
    public void press(double share) {
        flip.run();
    }

    @Override
    public void nudge(int direction) {
        flip.run();
    }
}
