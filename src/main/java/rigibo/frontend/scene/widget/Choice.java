package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Words;

import java.util.List;
import java.util.function.IntConsumer;
import java.util.function.IntSupplier;

/**
 * A choice of a few options, which a press cycles through.
 *
 * @param linked its name in links; empty if links do not set it
 * @param words its label
 * @param options the options
 * @param value index of the present option, from 0
 * @param change sets it
 */
public record Choice(
        String linked, String words, List<String> options, IntSupplier value, IntConsumer change)
        implements Widget {

    /** From here on, as a share of the width, a press goes on, before it goes back. */
    private static final double MIDDLE = 0.7;

    public Choice {
        options = List.copyOf(options);
    }

    /** A choice that no link makes. */
    public Choice(String words, List<String> options, IntSupplier value, IntConsumer change) {
        this("", words, options, value, change);
    }

    /** A choice that links make, with the word of a key. */
    public Choice(
            Words words, String key, List<String> options, IntSupplier value, IntConsumer change) {
        this(Widget.linked(key), words.of(key), options, value, change);
    }

    @Override
    public String setting() {
        return "" + value.getAsInt();
    }

    @Override
    public boolean set(String setting) {
        for (int i = 0; i < options.size(); i++) {
            if (setting.equals("" + i)) {
                change.accept(i);
                return true;
            }
        }
        return false;
    }

    @Override
    public void draw(Canvas canvas, double x, double y, double width, boolean isHot) {
        double row = Widget.row(canvas.layout());
        double middle = y + row / 2;
        Color ink = isHot ? Color.TEXT : Color.TEXT_DIM;
        double centre = x + MIDDLE * width;
        double right = x + width;
        double left = 2 * centre - right;
        Print.label(canvas, words, x, middle, left - x, ink);
        canvas.panel(left, y + 2, right - left, row - 4, 7, Color.PANEL_LIT);
        canvas.text(
                options.get(value.getAsInt()),
                centre,
                middle,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.CENTRE,
                Color.TEXT);
        arrow(canvas, left + 14, middle, -1);
        arrow(canvas, right - 14, middle, 1);
    }

    private static void arrow(Canvas canvas, double x, double y, int direction) {
        canvas.line(x - 3 * direction, y - 6, x + 3 * direction, y, 2, Color.BRASS);
        canvas.line(x + 3 * direction, y, x - 3 * direction, y + 6, 2, Color.BRASS);
    }

    @Override
    public void describe(Narrator narrator, Plate place, boolean isHot) {
        String name = words + ": " + options.get(value.getAsInt());
        // A press on the right half of its plate goes on.
        narrator.offers(place.control(name, Control.Kind.BUTTON, (1 + MIDDLE) / 2, isHot));
    }

    @Override
    public void press(double share) {
        nudge(share < MIDDLE ? -1 : 1);
    }

    @Override
    public void nudge(int direction) {
        change.accept(Math.floorMod(value.getAsInt() + direction, options.size()));
    }
}
