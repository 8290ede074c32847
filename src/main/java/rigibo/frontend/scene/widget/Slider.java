package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;
import rigibo.frontend.scene.Control;
import rigibo.frontend.scene.Narrator;
import rigibo.frontend.scene.Words;

import java.util.function.DoubleConsumer;
import java.util.function.DoubleFunction;
import java.util.function.DoubleSupplier;
import java.util.regex.Pattern;

/**
 * A number between two bounds, in equal notches.
 *
 * @param words the player's
 * @param key of its label
 * @param shown how the number is written, with its unit
 * @param least lower bound
 * @param most upper bound
 * @param notch the step between values
 * @param value the present value
 * @param change sets it
 */
public record Slider(
        Words words,
        String key,
        DoubleFunction<String> shown,
        double least,
        double most,
        double notch,
        DoubleSupplier value,
        DoubleConsumer change)
        implements Widget {

    /** The middles of words and rail, as shares of a row. */
    private static final double WORDS = 11 / ROW;

    private static final Pattern NUMBER = Pattern.compile("-?[0-9]+(\\.[0-9]+)?");

    /** One over the finest number that links hold. */
    private static final double DIGITS = 1e4;

    private static final double RAIL = 25 / ROW;

    /**
     * A slider that shows its value itself.
     *
     * @param format as of {@link Words#number}
     */
    public Slider(
            Words words,
            String key,
            String format,
            double least,
            double most,
            double notch,
            DoubleSupplier value,
            DoubleConsumer change) {
        this(words, key, v -> words.number(format, v), least, most, notch, value, change);
    }

    /** Its name. */
    public String label() {
        return words.of(key);
    }

    @Override
    public void draw(Canvas canvas, double x, double y, double width, boolean isHot) {
        double share = share();
        double row = Widget.row(canvas.layout());
        double middle = y + row * WORDS;
        Color ink = isHot ? Color.TEXT : Color.TEXT_DIM;
        canvas.text(label(), x, middle, 16, Canvas.Font.WORDS, Canvas.Align.LEFT, ink);
        canvas.text(
                shown.apply(value.getAsDouble()),
                x + width,
                middle,
                16,
                Canvas.Font.NUMBERS,
                Canvas.Align.RIGHT,
                Color.TEXT);
        double rail = y + row * RAIL;
        double knob = canvas.layout().lettered(isHot ? 7 : 6);
        canvas.panel(x, rail - 2, width, 4, 2, Color.PANEL_LIT);
        canvas.panel(x, rail - 2, Math.max(4, width * share), 4, 2, Color.BRASS);
        canvas.disc(x + width * share, rail, knob, Color.BRASS);
    }

    @Override
    public void describe(Narrator narrator, Plate place, boolean isHot) {
        String name = label() + ": " + shown.apply(value.getAsDouble());
        narrator.offers(place.control(name, Control.Kind.SLIDER, share(), isHot));
    }

    @Override
    public void press(double share) {
        set(least + share * (most - least));
    }

    @Override
    public boolean isDragged() {
        return true;
    }

    @Override
    public void nudge(int direction) {
        set(value.getAsDouble() + direction * notch);
    }

    @Override
    public String linked() {
        return Widget.linked(key);
    }

    @Override
    public String setting() {
        double rounded = Math.round(value.getAsDouble() * DIGITS) / DIGITS;
        return rounded == Math.rint(rounded) ? "" + Math.round(rounded) : "" + rounded;
    }

    @Override
    public boolean set(String setting) {
        if (!NUMBER.matcher(setting).matches()) {
            return false;
        }
        double wanted = Double.parseDouble(setting);
        boolean isInside = wanted >= least && wanted <= most;
        if (isInside) {
            set(wanted);
        }
        return isInside;
    }

    /** The present value as a share of the way between the bounds. */
    private double share() {
        return (value.getAsDouble() - least) / (most - least);
    }

    private void set(double wanted) {
        double notched = least + Math.round((wanted - least) / notch) * notch;
        change.accept(Math.max(least, Math.min(most, notched)));
    }
}
