package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Words;

import java.util.function.BooleanSupplier;

/**
 * Switches something on and off.
 *
 * @param linked its name in links; empty if links do not set it
 * @param words its label
 * @param isOn the present state
 * @param flip changes it
 */
public record Toggle(String linked, String words, BooleanSupplier isOn, Runnable flip)
        implements Widget {

    private static final String ON = "on";
    private static final String OFF = "off";

    /** A switch that no link sets. */
    public Toggle(String words, BooleanSupplier isOn, Runnable flip) {
        this("", words, isOn, flip);
    }

    /** A switch that links set, with the word of a key. */
    public Toggle(Words words, String key, BooleanSupplier isOn, Runnable flip) {
        this(Widget.linked(key), words.of(key), isOn, flip);
    }

    @Override
    public String setting() {
        return isOn.getAsBoolean() ? ON : OFF;
    }

    @Override
    public boolean set(String setting) {
        boolean isSetting = setting.equals(ON) || setting.equals(OFF);
        if (isSetting && !setting.equals(setting())) {
            flip.run();
        }
        return isSetting;
    }

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
