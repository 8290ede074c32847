package rigibo.frontend.scene.widget;

import rigibo.frontend.scene.Canvas;
import rigibo.frontend.scene.Color;

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
        double middle = y + ROW / 2;
        canvas.text(
                words,
                x,
                middle,
                16,
                Canvas.Font.WORDS,
                Canvas.Align.LEFT,
                isHot ? Color.TEXT : Color.TEXT_DIM);
        canvas.panel(x + width - 40, middle - 10, 40, 20, 10, on ? Color.GOOD : Color.PANEL_LIT);
        canvas.disc(x + width - (on ? 10 : 30), middle, 7, Color.TEXT);
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
